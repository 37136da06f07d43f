// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/opening_features.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "model/part_classes.h"
#include "modelling/facade/part_rules.h"

namespace jalon {

namespace {

constexpr double kFeatureChord_m = 0.01;
constexpr double kStep_m = 0.35,
                 kStepSoft_m = 0.08;  // a step or a plinth below a door, a sill above
constexpr double kStorey_m = 2.3, kStoreySoft_m = 0.25;  // the lowest ceiling of a ground floor
constexpr double kShallow_m = 0.05;                      // leaves and panels flush with the wall
constexpr double kSmall_m2 = 0.5;                        // vents
constexpr double kUnknownDepth_m = 0.2;                  // usual: half a wall
constexpr double kSetBackLeast_m = 0.4, kSetBackMost_m = 4.5;  // of loggias; of arcades
constexpr double kSameSizeRatio = 0.2;                         // difference of logarithms
constexpr double kSameHeight_m = 0.3;
constexpr double kBeside = 0.5;  // of the lower one's height, what two of one storey have in common
constexpr double kSillLeast_m = 0.5;  // a door's foot lies so far below windows' ones
constexpr double kSameAxis = 0.1, kSameSides = 0.15;  // widths; difference of logarithms
constexpr double kParallelWalls = 0.985;              // cosine of 10 degrees
constexpr double kLeastSize_m = 0.05;

struct Place {
  Box3 box;
  double ground_m = 0;
  const FacadeOpening* opening = nullptr;
  double width() const { return std::max(kLeastSize_m, box.max.x - box.min.x); }
  double height() const { return std::max(kLeastSize_m, box.max.z - box.min.z); }
  double foot_m() const { return box.min.z - ground_m; }
};

double soft_step(double value, double at, double width) {
  return 1 / (1 + std::exp((at - value) / width));
}

Box3 box_of(const FacadeFrame& frame, const PlaneFrame& plane, const VectorRing& ring) {
  Box3 box;
  for (const Vec2& p : flattened(ring, kFeatureChord_m)) box.add(frame.local(plane.lift(p)));
  return box;
}

// A level piece before the facade, and its height where it meets the wall.
struct Ground {
  Box3 box;
  Plane plane;  // in the facade's coordinates

  double height_at(double x) const { return (plane.offset - plane.normal.x * x) / plane.normal.z; }
};

std::vector<Ground> grounds_before(const FacadePlan& plan, const PlannedFacade& facade) {
  std::vector<Ground> out;
  const FacadeFrame& frame = facade.group.frame;
  for (const size_t index : facade.elements) {
    const VectorPlane& plane = plan.planes[index];
    for (const VectorFace& face : plane.faces) {
      const Vec3& n = plane.frame.normal;
      const Vec3 normal{dot(n, frame.along), dot(n, frame.outward), n.z};
      const Box3 box = box_of(frame, plane.frame, face.outline);
      if (std::string_view(class_of_element({box, normal, area(face)}, {facade.group.box, {}})) !=
          part_class::kGround)
        continue;
      const Vec3 at = frame.local(plane.frame.lift(face.outline.corners.front()));
      out.push_back({box, {normal, dot(normal, at)}});
    }
  }
  return out;
}

// Of the ground nearest to a place at the wall's foot; the walls' own foot where there is none.
double ground_height(const std::vector<Ground>& grounds, double x, double otherwise) {
  double nearest = INFINITY, out = otherwise;
  for (const Ground& ground : grounds) {
    const double beside = std::max({0.0, ground.box.min.x - x, x - ground.box.max.x});
    const double away = beside + std::max(0.0, ground.box.min.y);
    if (away >= nearest) continue;
    nearest = away;
    out = ground.height_at(std::clamp(x, ground.box.min.x, ground.box.max.x));
  }
  return out;
}

// Share of an opening in front of a wall that stands farther back.
double set_back_share(const FacadePlan& plan, const FacadeFrame& frame, size_t own,
                      const Place& place) {
  double share = 0;
  const double area_m2 = place.width() * place.height();
  const auto look = [&](size_t index) {
    const VectorPlane& plane = plan.planes[index];
    if (index == own || std::fabs(dot(plane.frame.normal, frame.outward)) < kParallelWalls) return;
    double covered_m2 = 0;
    for (const VectorFace& face : plane.faces) {
      const Box3 box = box_of(frame, plane.frame, face.outline);
      const double behind = place.box.min.y - box.max.y;
      if (behind < kSetBackLeast_m || behind > kSetBackMost_m) continue;
      const double u = std::min(box.max.x, place.box.max.x) - std::max(box.min.x, place.box.min.x);
      const double v = std::min(box.max.z, place.box.max.z) - std::max(box.min.z, place.box.min.z);
      if (u > 0 && v > 0) covered_m2 += u * v;
    }
    share = std::max(share, std::min(1.0, covered_m2 / area_m2));
  };
  for (const PlannedFacade& facade : plan.facades) {
    for (const PlannedWall& wall : facade.walls) look(wall.plane);
    for (const size_t element : facade.elements) look(element);
  }
  return share;
}

bool is_same_size(const Place& a, const Place& b) {
  return std::fabs(std::log(a.width() / b.width())) <= kSameSizeRatio &&
         std::fabs(std::log(a.height() / b.height())) <= kSameSizeRatio;
}

double on_ground(const Place& place) { return 1 - soft_step(place.foot_m(), kStep_m, kStepSoft_m); }
double upstairs(const Place& place) { return soft_step(place.foot_m(), kStorey_m, kStoreySoft_m); }

// What the others of a facade say of one of its openings.
struct Neighbours {
  size_t same_row = 0, same_size = 0;
  double over_door = 0;
};

bool is_beside(const Place& a, const Place& b) {
  const double both = std::min(a.box.max.z, b.box.max.z) - std::max(a.box.min.z, b.box.min.z);
  return both >= kBeside * std::min(a.height(), b.height());
}

// How much one looks like another one's twin over it, that stands on the ground.
double stands_over(const Place& place, const Place& other) {
  const auto likeness = [](double off, double by) { return std::exp(-off * off / (2 * by * by)); };
  const double axis = (place.box.min.x + place.box.max.x - other.box.min.x - other.box.max.x) / 2;
  return upstairs(place) * on_ground(other) * likeness(axis / place.width(), kSameAxis) *
         likeness(std::log(place.width() / other.width()), kSameSides) *
         likeness(std::log(place.height() / other.height()), kSameSides);
}

// 1 where it reaches down to the floor and the middle one of those beside it does not.
double below_others(const Place& place, std::vector<double> feet) {
  if (feet.empty()) return 0;
  const auto middle = feet.begin() + static_cast<ptrdiff_t>(feet.size() / 2);
  std::nth_element(feet.begin(), middle, feet.end());
  return std::clamp((*middle - place.box.min.z) / kSillLeast_m, 0.0, 1.0);
}

Neighbours neighbours_of(const std::vector<Place>& places, size_t own) {
  const Place& place = places[own];
  Neighbours out;
  std::vector<double> feet;
  for (size_t k = 0; k < places.size(); ++k) {
    if (k == own) continue;
    const Place& other = places[k];
    if (is_beside(place, other)) feet.push_back(other.box.min.z);
    out.over_door = std::max(out.over_door, stands_over(place, other));
    if (!is_same_size(place, other)) continue;
    ++out.same_size;
    out.same_row += std::fabs(place.box.min.z - other.box.min.z) <= kSameHeight_m;
  }
  out.over_door *= below_others(place, std::move(feet));
  return out;
}

OpeningFeatures features_of(const Place& place, double set_back, const Neighbours& neighbours) {
  const FacadeOpening& o = *place.opening;
  const auto& edges = o.outline.edges;
  const auto arcs = std::count_if(edges.begin(), edges.end(),
                                  [](const VectorEdge& e) { return e.sagitta_m != 0; });
  const double w = std::log(place.width()), h = std::log(place.height());
  const bool has_depth = std::isfinite(o.depth_m);
  const double depth = std::clamp(has_depth ? o.depth_m : kUnknownDepth_m, 0.0, 1.0);
  const double shallow = has_depth ? std::exp(-depth / kShallow_m) : 0;
  const double at_ground = on_ground(place);
  const double row = std::log1p(static_cast<double>(neighbours.same_row));
  OpeningFeatures out{};
  const auto set = [&](OpeningFeature which, double value) {
    out[static_cast<size_t>(which)] = value;
  };
  using enum OpeningFeature;
  set(kOne, 1);
  set(kWidth, w), set(kHeight, h);
  set(kWidthSquared, w * w), set(kHeightSquared, h * h), set(kWidthByHeight, w * h);
  set(kFoot, std::clamp(place.foot_m(), 0.0, 2.0));
  set(kOnGround, at_ground);
  set(kUpstairs, upstairs(place));
  set(kHead, std::clamp(place.box.max.z - place.ground_m, 0.0, 5.0));
  set(kDepth, depth), set(kNoDepth, has_depth ? 0 : 1), set(kShallow, shallow);
  set(kJoinery, o.content.joinery), set(kBehind, o.content.behind), set(kEmpty, o.content.empty);
  set(kSetBack, set_back);
  set(kSameRow, row), set(kSameSize, std::log1p(static_cast<double>(neighbours.same_size)));
  set(kArched, arcs > 0 ? 1 : 0);
  set(kRound, arcs == static_cast<ptrdiff_t>(edges.size()) ? 1 : 0);
  set(kAtBorder, o.is_notch ? 1 : 0);
  set(kGroundWidth, at_ground * w), set(kGroundHeight, at_ground * h);
  set(kGroundJoinery, at_ground * o.content.joinery);
  set(kGroundBehind, at_ground * o.content.behind);
  set(kGroundEmpty, at_ground * o.content.empty);
  set(kGroundSameRow, at_ground * row), set(kGroundDepth, at_ground * depth);
  set(kSmallShallow, place.width() * place.height() < kSmall_m2 ? shallow : 0);
  set(kOverDoor, neighbours.over_door);
  return out;
}

}  // namespace

std::vector<std::vector<OpeningFeatures>> opening_features(const FacadePlan& plan,
                                                           const PlannedFacade& facade) {
  const FacadeFrame& frame = facade.group.frame;
  // 1. Where each opening is, and the ground before it.
  const std::vector<Ground> grounds = grounds_before(plan, facade);
  std::vector<Place> places;
  for (const PlannedWall& wall : facade.walls)
    for (const FacadeOpening& o : wall.wall.openings) {
      Place place{box_of(frame, wall.wall.frame, o.outline), 0, &o};
      place.ground_m =
          ground_height(grounds, (place.box.min.x + place.box.max.x) / 2, facade.group.box.min.z);
      places.push_back(place);
    }
  // 2. Each with its neighbours.
  std::vector<std::vector<OpeningFeatures>> out;
  size_t next = 0;
  for (const PlannedWall& wall : facade.walls) {
    auto& rows = out.emplace_back();
    for (size_t k = 0; k < wall.wall.openings.size(); ++k, ++next) {
      const Place& place = places[next];
      rows.push_back(features_of(place, set_back_share(plan, frame, wall.plane, place),
                                 neighbours_of(places, next)));
    }
  }
  return out;
}

}  // namespace jalon
