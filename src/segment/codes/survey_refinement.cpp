// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/survey_refinement.h"

#include <cmath>

#include "base/parallel.h"
#include "base/text_number.h"
#include "geometry/polygon2.h"
#include "segment/codes/ajar_leaf.h"
#include "segment/codes/building_sides.h"
#include "segment/codes/opening_front.h"
#include "segment/codes/opening_sides.h"
#include "segment/codes/pipe_places.h"
#include "segment/codes/plan_tiles.h"
#include "segment/codes/survey_space.h"

namespace jalon {

namespace {

constexpr size_t kRefinedPerChunk = 1 << 14;
constexpr double kAside_m = 0.02;         // two steps from a frame tell which way is out
constexpr double kAboutPlane_m = 0.07;    // within which the front of an opening is looked for
constexpr double kShiftedPipe_m = 0.015;  // the thesis' margin about pipes is 0.02
constexpr double kFittedPipeMargin_m = 0.01;

bool is_opening(const CodedObject& object) {
  return object.shape.kind == CodeShape::Kind::kRectangle ||
         object.shape.kind == CodeShape::Kind::kOutline;
}

// The same pipes, and openings with a thicker layer, wherever they lie in a building: of a frame far behind the eaves
// the panes lie where the shell is hollow.
CodedObjects thickened(const CodedObjects& objects) {
  CodedObjects out{objects.origin, objects.objects, {}};
  for (CodedObject& object : out.objects)
    if (is_opening(object)) object.row.distance_m = kAboutPlane_m;
    else if (object.shape.kind == CodeShape::Kind::kPrism)
      object.shape.kind = CodeShape::Kind::kNone;
  return out;
}

// Of the objects the buildings alone.
CodedObjects buildings_of(const CodedObjects& objects) {
  CodedObjects out{objects.origin, objects.objects, {}};
  for (CodedObject& object : out.objects)
    if (object.shape.kind != CodeShape::Kind::kPrism) object.shape.kind = CodeShape::Kind::kNone;
  return out;
}

// Along the opening's plane, and before it: u = 0 at corner a; v positive on the outer side.
struct OpeningPlane {
  Vec2 from, along, outward;
  bool has_outside = false;
  Vec2 of(const Vec3& p) const {
    const Vec2 d = in_plan(p) - from;
    return {dot(d, along), dot(d, outward)};
  }
};

class Refinement {
 public:
  Refinement(const Cloud& cloud, const CodeTable& table, const CodedObjects& objects,
             const SurveyCodeSettings& settings, Task& task)
      : cloud_(cloud),
        objects_(objects),
        settings_(settings),
        about_(settings),
        task_(task),
        thick_(thickened(objects)),
        bare_(buildings_of(objects)),
        near_(table, thick_, wide(about_)),
        shells_(table, bare_, settings),
        tiles_(cloud, objects.origin, task) {}

  // 1. the points about each opening; 2. its front among them; 3. points at it and up to the text's distance behind it
  // are the opening's, the others their wall's.
  void openings(std::vector<uint32_t>& object_of_point) {
    const std::vector<uint32_t> near = objects_near();
    std::vector<std::vector<uint32_t>> points(objects_.objects.size());
    for (uint32_t i = 0; i < near.size(); ++i)
      if (near[i] != 0 && is_opening(objects_.objects[near[i] - 1]))
        points[near[i] - 1].push_back(i);
    for (size_t k = 0; k < points.size(); ++k)
      if (!points[k].empty()) share(k, points[k], object_of_point);
  }

  // 4. pipes: what lies on the circle, up to five times the noise; nobody sees into a pipe, or the side of it that
  // faces its wall.
  void pipes(const std::vector<PipePlace>& places, std::vector<uint32_t>& object_of_point) {
    std::vector<Vec2> outward;
    for (const PipePlace& place : places)
      outward.push_back(way_out_at_pipe(objects_, place.circle.centre));
    parallel_for(task_, cloud_.size(), kRefinedPerChunk, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i)
        for (size_t k = 0; k < places.size(); ++k) {
          const PipePlace& place = places[k];
          const Vec3 p = local(i);
          const CodeShape& shape = objects_.objects[place.object].shape;
          const auto number = static_cast<uint32_t>(place.object + 1);
          const bool is_on = p.z > shape.low_m && p.z < shape.high_m &&
                             std::fabs(place.circle.distance(in_plan(p))) < kFittedPipeMargin_m &&
                             dot(in_plan(p) - place.circle.centre, outward[k]) >
                                 -kPipeBackShare * place.circle.radius;
          if (is_on) object_of_point[i] = number;
          else if (object_of_point[i] == number) object_of_point[i] = shells_.object_at(p);
        }
    });
  }

 private:
  // Walls stand along the axes too: the box about an opening must be as deep as the layer.
  static SurveyCodeSettings& wide(SurveyCodeSettings& settings) {
    settings.opening_margin_m = std::max(settings.opening_margin_m, kAboutPlane_m);
    return settings;
  }

  // Beside its corners or its outline by the margin at most.
  bool is_beside(const CodedObject& object, const OpeningPlane& plane, const Vec3& p) const {
    return is_within(object, plane, p, settings_.opening_margin_m);
  }
  static bool is_within(const CodedObject& object, const OpeningPlane& plane, const Vec3& p,
                        double margin) {
    const CodeShape& s = object.shape;
    const double u = plane.of(p).u, width = norm(in_plan(s.corner_b - s.corner_a));
    if (s.kind == CodeShape::Kind::kOutline)
      return contains(s.polygon, Vec2{u, p.z}) || border_distance(s.polygon, Vec2{u, p.z}) < margin;
    return u > -margin && u < width + margin && p.z > s.low_m - margin && p.z < s.high_m + margin;
  }

  static OpeningEnds ends_of(const CodedObject& object) {
    const CodeShape& s = object.shape;
    return {0, norm(in_plan(s.corner_b - s.corner_a)), s.low_m, s.high_m};
  }

  Vec3 local(size_t i) const { return cloud_.point(i) - objects_.origin; }

  std::vector<uint32_t> objects_near() {
    std::vector<uint32_t> near(cloud_.size());
    parallel_for(task_, near.size(), kRefinedPerChunk, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) near[i] = near_.object_at(local(i));
    });
    return near;
  }

  // The outer side is where the way out of the nearest building is shorter; without a building there is none.
  OpeningPlane plane_of_opening(const CodedObject& object) const {
    const CodeShape& s = object.shape;
    const Vec2 base = in_plan(s.corner_b - s.corner_a), along = base * (1 / norm(base));
    OpeningPlane plane{in_plan(s.corner_a), along, {along.v, -along.u}, false};
    const Vec2 middle = in_plan(0.5 * (s.corner_a + s.corner_b)), aside = plane.outward * kAside_m;
    const double there = depth_in_buildings(objects_, middle + aside),
                 here = depth_in_buildings(objects_, middle - aside);
    plane.has_outside = std::isfinite(there);
    if (there > here) plane.outward = plane.outward * -1;
    return plane;
  }

  void share(size_t k, const std::vector<uint32_t>& points,
             std::vector<uint32_t>& object_of_point) {
    const CodedObject& object = objects_.objects[k];
    const OpeningPlane plane = plane_of_opening(object);
    std::vector<Vec3> flat, inner;  // in the margin stands the wall
    std::vector<uint32_t> kept;
    for (const uint32_t i : points)
      if (is_beside(object, plane, local(i))) {
        kept.push_back(i);
        const Vec2 at = plane.of(local(i));
        flat.push_back({at.u, at.v, local(i).z});
        if (is_within(object, plane, local(i), 0)) inner.push_back(flat.back());
      }
    OpeningFront front;
    if (!find_opening_front(inner, front)) return;
    const OpeningSides sides(flat, front, ends_of(object));
    const auto number = static_cast<uint32_t>(k + 1);
    const double depth = depth_behind(front, object.row.distance_m);
    for (size_t j = 0; j < kept.size(); ++j) {
      const double before = flat[j].y - front.before(flat[j].x);
      const double most = plane.has_outside ? kBeforeFront_m : object.row.distance_m;
      const bool is_its = before < most && before > -depth &&
                          !(plane.has_outside && sides.is_reveal(flat[j], front));
      uint32_t& owner = object_of_point[kept[j]];
      if (is_its) owner = number;
      else if (owner == number) owner = shells_.object_at(local(kept[j]));
    }
    if (plane.has_outside) share_ajar(k, plane, front, object_of_point);
  }

  // A leaf that stands open is its opening's, wherever behind the wall it ends.
  void share_ajar(size_t k, const OpeningPlane& plane, const OpeningFront& front,
                  std::vector<uint32_t>& object_of_point) {
    const CodedObject& object = objects_.objects[k];
    const auto number = static_cast<uint32_t>(k + 1);
    const OpeningEnds ends = ends_of(object);
    const double width = ends.right_m, margin = settings_.opening_margin_m;
    std::vector<Vec3> flat;
    std::vector<uint32_t> kept;
    const Vec2 middle = in_plan(0.5 * (object.shape.corner_a + object.shape.corner_b));
    for (const uint32_t i : tiles_.points_about(middle, width)) {
      const uint32_t owner = object_of_point[i];
      const Vec2 at = plane.of(local(i));
      const bool is_of_another = owner != 0 && owner != number &&
                                 objects_.objects[owner - 1].shape.kind != CodeShape::Kind::kPrism;
      if (is_of_another || !is_beside(object, plane, local(i)) || at.v > margin ||
          at.v < -kWidestAjar * width - kAboutPlane_m)
        continue;
      flat.push_back({at.u, at.v, local(i).z});
      kept.push_back(i);
    }
    AjarLeaf leaf;
    if (!find_ajar_leaf(flat, front, ends, width, leaf)) return;
    for (size_t j = 0; j < kept.size(); ++j)
      if (leaf.holds(flat[j], object.row.distance_m)) object_of_point[kept[j]] = number;
  }

  const Cloud& cloud_;
  const CodedObjects& objects_;
  const SurveyCodeSettings& settings_;
  SurveyCodeSettings about_;
  Task& task_;
  CodedObjects thick_, bare_;
  SurveySpace near_, shells_;
  PlanTiles tiles_;
};

}  // namespace

void refine_survey(const Cloud& cloud, const CodeTable& table, const CodedObjects& objects,
                   const SurveyCodeSettings& settings, std::vector<uint32_t>& object_of_point,
                   Task& task) {
  Refinement refinement(cloud, table, objects, settings, task);
  refinement.openings(object_of_point);
  refinement.pipes(pipe_places(cloud, objects, task), object_of_point);
}

void warn_of_shifted_pipes(const Cloud& cloud, CodedObjects& objects, Task& task) {
  for (const PipePlace& place : pipe_places(cloud, objects, task)) {
    const CodedObject& object = objects.objects[place.object];
    if (place.off_m > kShiftedPipe_m)
      objects.warnings.push_back(
          {object.points.front().line, object.name,
           "its points lie about a place " + text_of(place.off_m, 3) + " m from the surveyed one"});
  }
}

}  // namespace jalon
