// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "segment/codes/ajar_leaf.h"
#include "segment/codes/opening_front.h"
#include "segment/codes/opening_sides.h"
#include "segment/codes/target_leaf.h"
#include "segment/codes/target_scene.h"

namespace jalon {

namespace {

constexpr double kApart_m = 0.15;  // of frames along a facade: a narrow pier
constexpr double kSoughtIn =
    2;  // times the distance about a target's plane: where its front may be

// How far two targets of a facade may lie off their common plane, and the cosine of 20 degrees between it and the patch
// of 10 cm at each.
constexpr double kOneFacade_m = 0.05, kOneFacadeCosine = 0.94;
constexpr double kAboutWall_m = 0.5;     // as between the two measurements of a corner
constexpr double kWidestWindow_m = 2.5;  // of one storey high
constexpr double kFlush_m = 0.1;         // of a pane behind a wall whose waves may reach its leaf
constexpr double kWithinLeaf_m = 0.4;    // about a target: half of the width of a narrow door

// The nearest wall along a door's or window's plane: it stands before it, on the outer side. Nothing where no target's
// wall is near and parallel.
const TargetWall* wall_before(const TargetScene& scene, const Plane& plane, const Vec3& place) {
  const TargetWall* found = nullptr;
  double nearest = kAboutWall_m;
  for (const TargetWall& wall : scene.walls) {
    const double off = std::fabs(wall.plane.distance(place));
    if (off > nearest || std::fabs(dot(wall.plane.normal, plane.normal)) < kOneFacadeCosine)
      continue;
    nearest = off;
    found = &wall;
  }
  return found;
}

// How far the wall stands before a place of the plane, on the side of its normal.
double wall_offset(const TargetWall& wall, const Plane& plane, const Vec3& place) {
  const double d = wall.plane.distance(place);
  return dot(wall.plane.normal, plane.normal) > 0 ? -d : d;
}

// The plane through a place that stands upright: patches of 10 cm tell little of a lean.
Plane upright(const Plane& plane, const Vec3& place) {
  const Vec3 normal = normalized(Vec3{plane.normal.x, plane.normal.y, 0});
  return {normal, dot(normal, place)};
}

// An upright plane of openings, behind or in the wall that tells where outside is.
struct PaneFrame {
  Plane plane;
  Vec3 along;
  double outside = 1;
  Vec3 of(const Vec3& p) const { return {dot(p, along), outside * plane.distance(p), p.z}; }
};

// Where the points of one or more openings are looked for: between two places, widened in plan and in height.
struct PaneRange {
  Vec3 a, b;
  double margin_m = 0;  // in plan
  double low_m = 0, high_m = 0;
  double beyond_m = 0;  // of the far end of an opening that begins within the margin

  Vec2 middle() const { return in_plan(a + b) * 0.5; }
  double reach_m() const { return norm(in_plan(b - a)) / 2 + margin_m; }
  std::pair<double, double> along(const Vec3& direction) const {
    const double s = dot(a, direction), t = dot(b, direction);
    return {std::min(s, t) - margin_m, std::max(s, t) + margin_m};
  }
};

PaneFrame frame_before(const TargetWall& wall, const Plane& plane, const Vec3& place) {
  PaneFrame frame;
  frame.plane = upright(plane, place);
  frame.along = normalized(cross(Vec3{0, 0, 1}, frame.plane.normal));
  frame.outside = wall_offset(wall, frame.plane, place) > 0 ? 1 : -1;
  return frame;
}

// Where the points at a front end, but for the outermost of five hundred on either side: noise.
void set_ends(std::vector<double>& places, double& low, double& high) {
  constexpr double kOutermost = 0.002;
  const auto at = [&](double share) {
    const auto k = places.begin() +
                   static_cast<std::ptrdiff_t>(share * static_cast<double>(places.size() - 1));
    std::nth_element(places.begin(), k, places.end());
    return *k;
  };
  low = at(kOutermost), high = at(1 - kOutermost);
}

// What of one frame or leaf lies at its front and up to the distance behind it.
void add_at_front(TargetScene& scene, const PaneFrame& frame, std::span<const Vec3> flat,
                  std::span<const uint32_t> points, double distance_m, std::vector<uint32_t>& out) {
  FoundOpening found;
  found.plane = frame.plane, found.along = frame.along, found.outside = frame.outside;
  if (!find_opening_front(flat, found.front)) return;
  const double depth = depth_behind(found.front, distance_m);
  std::vector<double> places, heights;
  std::vector<size_t> its;
  for (size_t k = 0; k < points.size(); ++k) {
    const double before = flat[k].y - found.front.before(flat[k].x);
    if (before < kBeforeFront_m && before > -depth) its.push_back(k);
    if (std::fabs(before) > kLeafNoise_m) continue;
    places.push_back(flat[k].x);
    heights.push_back(flat[k].z);
  }
  if (!places.empty()) {
    set_ends(places, found.left_m, found.right_m);
    set_ends(heights, found.low_m, found.high_m);
    scene.openings.push_back(found);
  }
  const OpeningSides sides(flat, found.front,
                           {found.left_m, found.right_m, found.low_m, found.high_m});
  for (const size_t k : its)
    if (!sides.is_reveal(flat[k], found.front)) out.push_back(points[k]);
}

// Whether what lies along the plane is left of an opening that was found: a door's, beside windows.
bool is_found(const TargetScene& scene, const PaneFrame& frame, std::span<const Vec3> flat) {
  const double middle = (flat.front().x + flat.back().x) / 2;
  return std::any_of(scene.openings.begin(), scene.openings.end(), [&](const FoundOpening& o) {
    const Vec3 place = o.along * ((o.left_m + o.right_m) / 2) + o.plane.normal * o.plane.offset;
    const double half = (o.right_m - o.left_m) / 2;
    return std::fabs(dot(o.along, frame.along)) > kOneFacadeCosine &&
           std::fabs(frame.plane.distance(place)) < kAboutWall_m &&
           std::fabs(middle - dot(place, frame.along)) < half;
  });
}

// Form "improved": the points about a plane, apart where nothing lies along it, each group by its own front: windows of
// one facade differ in depth by centimetres. Groups count whole that reach into the range between two places along the
// plane, widened: a door's target, the two of a facade.
std::vector<uint32_t> at_fronts(TargetScene& scene, const PaneFrame& frame, double distance_m,
                                std::vector<uint32_t> points, const PaneRange& range) {
  const auto place = [&](uint32_t i) { return dot(scene.local(i), frame.along); };
  const auto [low, high] = range.along(frame.along);
  std::stable_sort(points.begin(), points.end(),
                   [&](uint32_t a, uint32_t b) { return place(a) < place(b); });
  std::vector<uint32_t> out;
  for (size_t first = 0, end; first < points.size(); first = end) {
    std::vector<Vec3> flat;
    for (end = first; end < points.size(); ++end) {
      const Vec3 p = frame.of(scene.local(points[end]));
      if (!flat.empty() && p.x - flat.back().x > kApart_m) break;
      flat.push_back(p);
    }
    if (flat.back().x < low || flat.front().x > high || is_found(scene, frame, flat)) continue;
    add_at_front(scene, frame, flat, std::span(points).subspan(first, end - first), distance_m,
                 out);
  }
  return out;
}

// The free points of an opening about its plane, among those that keep() takes; form "improved": the whole groups.
template <class Keep>
std::vector<uint32_t> opening_points(TargetScene& scene, const CodedObject& object,
                                     const Plane& plane, const PaneRange& range, Keep&& keep) {
  const TargetWall* wall =
      scene.is_improved() ? wall_before(scene, plane, scene.place(object.points.front())) : nullptr;
  const double distance = object.row.distance_m;
  if (wall == nullptr)
    return free_about(scene, range.middle(), range.reach_m() + range.beyond_m, [&](const Vec3& p) {
      return std::fabs(plane.distance(p)) < distance && keep(p);
    });
  const PaneFrame frame = frame_before(*wall, plane, scene.place(object.points.front()));
  const std::pair<double, double> ends = range.along(frame.along);
  std::vector<uint32_t> points =
      free_about(scene, range.middle(), range.reach_m() + range.beyond_m, [&](const Vec3& p) {
        const double at = dot(p, frame.along);
        return std::fabs(frame.plane.distance(p)) < distance * kSoughtIn && p.z > range.low_m &&
               p.z < range.high_m && at > ends.first - range.beyond_m &&
               at < ends.second + range.beyond_m;
      });
  return at_fronts(scene, frame, distance, std::move(points), range);
}

// Form "improved": a leaf that its wall took, even among the wall's waves.
bool take_flush_door(TargetScene& scene, uint32_t number) {
  const CodedObject& object = scene.objects.objects[number - 1];
  const auto plane = plane_of(scene, patch_of(scene, object.points.front(), true));
  if (!plane) return false;
  const Vec3 place = scene.place(object.points.front());
  const TargetWall* wall = wall_before(scene, *plane, place);
  if (wall == nullptr || std::fabs(wall->plane.distance(place)) > kFlush_m) return false;
  const PaneFrame frame = frame_before(*wall, wall->plane, place);
  const double radius = scene.settings.door_radius_m;
  std::vector<uint32_t> points;
  std::vector<Vec3> flat;
  for (const uint32_t i : scene.tiles.points_about(in_plan(place), radius)) {
    if (scene.owner[i] != 0 && scene.owner[i] != wall->object) continue;
    const Vec3 p = frame.of(scene.local(i));
    if (std::fabs(p.y) > kFlush_m) continue;
    points.push_back(i);
    flat.push_back(p);
  }
  TargetLeaf leaf;
  if (!find_leaf(flat, {dot(place, frame.along), place.z}, radius, leaf)) return false;
  std::vector<uint32_t> taken;
  size_t from_wall = 0;
  for (size_t k = 0; k < points.size(); ++k) {
    const double before = flat[k].y - leaf.front.before(flat[k].x);
    if (!leaf.holds(flat[k].x, flat[k].z) || before > kBeforeFront_m ||
        before < -object.row.distance_m)
      continue;
    taken.push_back(points[k]);
    from_wall += scene.owner[points[k]] != 0;
  }
  if (2 * from_wall < taken.size()) return false;
  for (const uint32_t i : taken) scene.owner[i] = number;
  FoundOpening found;
  found.plane = frame.plane, found.along = frame.along, found.outside = frame.outside;
  found.front = leaf.front;
  found.left_m = leaf.left_m, found.right_m = leaf.right_m;
  found.low_m = leaf.low_m, found.high_m = leaf.high_m;
  scene.openings.push_back(found);
  return true;
}

// A leaf of which other objects took the larger part, its wall first of all: it is flush with that.
bool is_lost(const TargetScene& scene, uint32_t number, const Plane& plane) {
  const CodedObject& object = scene.objects.objects[number - 1];
  const Vec3 place = scene.place(object.points.front());
  size_t its = 0, others = 0;
  for (const uint32_t i : scene.tiles.points_about(in_plan(place), kWithinLeaf_m)) {
    const Vec3 p = scene.local(i);
    if (scene.owner[i] == 0 || std::fabs(plane.distance(p)) > object.row.distance_m ||
        norm(p - place) > kWithinLeaf_m)
      continue;
    ++(scene.owner[i] == number ? its : others);
  }
  return others > its;
}

void take_door(TargetScene& scene, uint32_t number) {
  if (scene.is_improved() && take_flush_door(scene, number)) return;
  const CodedObject& object = scene.objects.objects[number - 1];
  const CodedPoint& target = object.points.front();
  const auto plane = plane_of(scene, patch_of(scene, target, false));
  if (!plane)
    return warn_of_target(
        scene, object,
        "fewer than three free points lie at its target: flush with its wall, or hidden");
  const Vec3 centre = scene.place(target);
  const double radius = scene.settings.door_radius_m;
  const PaneRange range{centre,           centre, kApart_m, centre.z - radius, centre.z + radius,
                        radius - kApart_m};
  for (const uint32_t i : opening_points(scene, object, *plane, range, [&](const Vec3& p) {
         return squared_norm(p - centre) < radius * radius;
       }))
    scene.owner[i] = number;
  if (is_lost(scene, number, *plane))
    warn_of_target(scene, object,
                   "most points about its target went to another object: flush with its wall");
}

// Strictly between two places, widened by the margin, along every axis.
bool between(const Vec3& p, const Vec3& a, const Vec3& b, double margin) {
  for (int k = 0; k < 3; ++k)
    if (!(p[k] > std::min(a[k], b[k]) - margin && p[k] < std::max(a[k], b[k]) + margin))
      return false;
  return true;
}

// Form "improved": of a leaf that stands open only what is about its hinge lies at the front; the rest of it follows.
void take_ajar(TargetScene& scene, FoundOpening& opening, uint32_t number) {
  const OpeningEnds ends{opening.left_m, opening.right_m, opening.low_m, opening.high_m};
  const auto place = [&](double s) {
    return in_plan(opening.along * s + opening.plane.normal * opening.plane.offset);
  };
  const double reach = kWidestWindow_m, deepest = kWidestAjar * reach;
  std::vector<Vec3> flat;
  std::vector<uint32_t> points;
  for (const uint32_t i :
       scene.tiles.points_about(place((ends.left_m + ends.right_m) / 2), reach + deepest)) {
    if (scene.owner[i] != 0 && scene.owner[i] != number) continue;
    const Vec3 p = scene.local(i);
    const Vec3 at{dot(p, opening.along), opening.outside * opening.plane.distance(p), p.z};
    const double before = at.y - opening.front.before(at.x);
    if (before > kApart_m || before < -deepest || p.z < ends.low_m - kApart_m ||
        p.z > ends.high_m + kApart_m)
      continue;
    flat.push_back(at);
    points.push_back(i);
  }
  AjarLeaf leaf;
  if (!find_ajar_leaf(flat, opening.front, ends, reach, leaf)) return;
  const double distance = scene.objects.objects[number - 1].row.distance_m;
  for (size_t k = 0; k < points.size(); ++k)
    if (leaf.holds(flat[k], distance)) scene.owner[points[k]] = number;
  // Its hole in the wall is as wide as the leaf.
  opening.front = {leaf.hinge.v, 0};
  if (leaf.along.u > 0) opening.right_m = std::max(ends.right_m, ends.left_m + leaf.length_m);
  else opening.left_m = std::min(ends.left_m, ends.right_m - leaf.length_m);
}

// A target and its patch with the plane of its facade.
bool agrees(const Plane& facade, const Vec3& place, const Plane& patch) {
  return std::fabs(facade.distance(place)) < kOneFacade_m &&
         std::fabs(dot(facade.normal, patch.normal)) > kOneFacadeCosine;
}

void take_facade(TargetScene& scene, uint32_t number) {
  const CodedObject& object = scene.objects.objects[number - 1];
  std::vector<uint32_t> patch;
  std::vector<Plane> own;
  for (const CodedPoint& target : object.points) {
    const std::vector<uint32_t> part = patch_of(scene, target, false);
    patch.insert(patch.end(), part.begin(), part.end());
    const auto plane = plane_of(scene, part);
    if (!plane)
      return warn_of_target(scene, object,
                            "fewer than three free points lie at target " + target.id);
    own.push_back(*plane);
  }
  const auto plane = plane_of(scene, patch);
  const Vec3 a = scene.place(object.points[0]), b = scene.place(object.points[1]);
  if (!plane || !agrees(*plane, a, own[0]) || !agrees(*plane, b, own[1]))
    return warn_of_target(scene, object, "its two targets are on no common plane: left out");
  const size_t first = scene.openings.size();
  // A margin along the axes is as much as 1.41 times longer along a facade, whatever its direction.
  const double margin = scene.settings.window_margin_m;
  const PaneRange range{a,
                        b,
                        std::numbers::sqrt2 * margin,
                        std::min(a.z, b.z) - margin,
                        std::max(a.z, b.z) + margin,
                        kWidestWindow_m};
  for (const uint32_t i : opening_points(scene, object, *plane, range,
                                         [&](const Vec3& p) { return between(p, a, b, margin); }))
    scene.owner[i] = number;
  for (size_t k = first; k < scene.openings.size(); ++k) {
    scene.openings[k].has_sill = true;
    take_ajar(scene, scene.openings[k], number);
  }
}

}  // namespace

bool are_on_one_facade(const TargetScene& scene, const CodedPoint& a, const CodedPoint& b) {
  std::vector<uint32_t> both = patch_of(scene, a, true);
  const std::vector<uint32_t> of_b = patch_of(scene, b, true);
  const auto plane_a = plane_of(scene, both), plane_b = plane_of(scene, of_b);
  if (!plane_a || !plane_b) return true;
  both.insert(both.end(), of_b.begin(), of_b.end());
  const auto plane = plane_of(scene, both);
  return plane && agrees(*plane, scene.place(a), *plane_a) &&
         agrees(*plane, scene.place(b), *plane_b);
}

void take_doors(TargetScene& scene, Task& task) {
  for (uint32_t number = 1; number <= scene.objects.objects.size(); ++number)
    if (scene.objects.objects[number - 1].row.geometry == CodeGeometry::kDoorTarget) {
      task.checkpoint(0.5);
      take_door(scene, number);
    }
}

void take_windows(TargetScene& scene, Task& task) {
  for (uint32_t number = 1; number <= scene.objects.objects.size(); ++number)
    if (scene.objects.objects[number - 1].row.geometry == CodeGeometry::kWindowTarget) {
      task.checkpoint(0.5);
      take_facade(scene, number);
    }
}

}  // namespace jalon
