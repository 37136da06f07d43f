// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/plan.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "modelling/contour/contour.h"
#include "modelling/evidence/contour_holes.h"
#include "modelling/facade/opening_classes.h"
#include "modelling/plane/ring_tools.h"
#include "modelling/walls/bays.h"
#include "modelling/walls/evident_holes.h"
#include "modelling/walls/openings.h"
#include "modelling/walls/sills.h"

namespace jalon {

namespace {

constexpr double kConsumedShare =
    0.6;  // of a segment's points in openings: it is their joinery or reveal

constexpr double kHiddenByCopy = 0.3;    // of a copy's box and of what was not seen there, together
constexpr double kBesideCopy = 3;        // spacings, as beside openings (drawn_contour.cpp)
constexpr double kChordOfSpacing = 0.1;  // of arcs, where only soundness is asked

// Points of each segment that lie in openings, no further before the wall than what is fixed there.
// What stands in an opening before its joinery is a part of its own.
void count_points(std::span<const int32_t> opening_of, const WallSurvey& survey,
                  const FacadeWall& wall, std::vector<uint64_t>& in_openings) {
  for (size_t h = 0; h < opening_of.size(); ++h) {
    if (opening_of[h] < 0) continue;
    const auto& standing = wall.openings[static_cast<size_t>(opening_of[h])].standing_labels;
    for (const HolePoint& p : survey.holes[h].points)
      if (std::find(standing.begin(), standing.end(), p.label) == standing.end())
        ++in_openings[p.label];
  }
}

PlannedWall planned_wall(const Segmentation& segmentation, const VectorPlane& plane, size_t index) {
  PlannedWall out;
  out.plane = index;
  const Segment& segment = segmentation.segments[index];
  out.wall.label = plane.label;
  out.wall.frame = plane.frame;
  out.wall.spacing_m = plane.spacing_m;
  out.wall.sigma_m = segment.fit.sigma;
  out.wall.covariance = segment.fit.covariance;
  for (const VectorFace& face : plane.faces) out.wall.outlines.push_back(face.outline);
  return out;
}

// All walls with their holes, facade by facade.
struct WallList {
  std::vector<std::vector<WallHole>> holes;
  std::vector<SurveyedWall> walls;
};

// The evidence that a plane was drawn by; none for panes and the like.
std::span<const OpeningCandidate> drawn_openings(std::span<const WallEvidence> evidence,
                                                 size_t plane) {
  if (evidence.empty() || !evidence[plane].is_drawn()) return {};
  return evidence[plane].openings;
}

// The holes of a wall's faces, and the bays between its pieces; walls drawn by their evidence have the bays of that.
std::vector<WallHole> interruptions_of(const std::vector<VectorPlane>& planes, size_t wall,
                                       std::span<const WallEvidence> evidence,
                                       const FacadeGroup& group, const PlanSetting& setting) {
  if (!evidence.empty() && evidence[wall].is_drawn())
    return evident_holes(planes[wall], evidence[wall].openings);
  std::vector<WallHole> out = holes_of(planes[wall], setting.group.notch);
  std::vector<WallHole> bays = bays_of(planes[wall], out, setting.group.notch);
  std::erase_if(bays, [&](const WallHole& bay) {
    return std::any_of(group.walls.begin(), group.walls.end(), [&](size_t other) {
      return other != wall &&
             is_walled_up(bay, planes[wall], planes[other], setting.survey.max_depth_m);
    });
  });
  out.insert(out.end(), bays.begin(), bays.end());
  if (!evidence.empty() && evidence[wall].is_wall()) {
    std::vector<OpeningCandidate> closed =
        evidence[wall].openings;  // a lattice's bays are told before
    std::erase_if(closed, [&](const OpeningCandidate& opening) {
      return opening.is_open_above || opening.shape.box().width() > setting.group.notch.max_width_m;
    });
    std::erase_if(out, [&](const WallHole& hole) {
      return hole.is_notch && !hole.is_bay && holds_several(hole, closed);
    });
    drop_second_notches(closed, out);
    add_bays(planes[wall], closed, out);
  }
  return out;
}

WallList list_walls(const Segmentation& segmentation, const FacadePlan& plan,
                    std::span<const WallEvidence> evidence, const PlanSetting& setting) {
  WallList out;
  for (const PlannedFacade& facade : plan.facades)
    for (const size_t plane : facade.group.walls)
      out.holes.push_back(interruptions_of(plan.planes, plane, evidence, facade.group, setting));
  size_t k = 0;
  for (const PlannedFacade& facade : plan.facades)
    for (const size_t plane : facade.group.walls)
      out.walls.push_back(
          {&plan.planes[plane], out.holes[k++], segmentation.segments[plane].fit.sigma});
  return out;
}

bool is_filled(const FacadeShadow& shadow, const FillSetting& setting, double spacing_m) {
  if (setting.fill != WallFill::kSmall) return setting.fill == WallFill::kOutline;
  const RingBox box = ring_box(shadow.outline);
  return std::max(box.width(), box.height()) <= setting.small_spacings * spacing_m;
}

// The faces and the outlines close over what is to be filled. Small ones are wall from here on; larger ones, filled
// because they were asked for, are told.
void fill_shadows(const FillSetting& setting, VectorPlane& plane, FacadeWall& wall) {
  for (FacadeShadow& shadow : wall.shadows) {
    shadow.is_filled = is_filled(shadow, setting, plane.spacing_m);
    if (shadow.is_filled)
      close_hole(plane.faces[shadow.piece], {shadow.outline, shadow.piece, shadow.is_notch});
  }
  if (setting.fill == WallFill::kSmall)
    std::erase_if(wall.shadows, [](const FacadeShadow& shadow) { return shadow.is_filled; });
  for (size_t f = 0; f < plane.faces.size(); ++f) wall.outlines[f] = plane.faces[f].outline;
}

// The wall's faces with these openings as their holes beside those where nothing was looked at; notches are in the
// outlines.
std::vector<VectorFace> faces_with(const VectorPlane& plane, std::span<const FacadeShadow> shadows,
                                   std::span<const FacadeOpening> openings) {
  std::vector<VectorFace> faces = plane.faces;
  for (VectorFace& face : faces) face.openings.clear();
  for (const FacadeShadow& shadow : shadows)
    if (!shadow.is_notch && !shadow.is_filled)
      faces[shadow.piece].openings.push_back(reversed(shadow.outline));
  for (const FacadeOpening& opening : openings)
    if (!opening.is_notch) faces[opening.piece].openings.push_back(reversed(opening.outline));
  return faces;
}

// What a copy leaves of a place without data: nobody measured that either. What is small across is wall between both.
std::vector<FacadeShadow> left_of(const FacadeShadow& shadow, const VectorRing& copy,
                                  const FillSetting& setting, double spacing_m) {
  const double chord_m = kChordOfSpacing * spacing_m, small_m = setting.small_spacings * spacing_m;
  const RingBox taken = ring_box(copy).grown(kBesideCopy * spacing_m);
  std::vector<FacadeShadow> out;
  for (PolygonWithHoles& part :
       without({{flattened(shadow.outline, chord_m), {}}},
               {box_polygon(taken.low.u, taken.low.v, taken.high.u, taken.high.v)}, spacing_m)) {
    if (equivalent_width(signed_area(part.outline), perimeter(part.outline)) <= small_m) continue;
    FacadeShadow& left = out.emplace_back();
    left.piece = shadow.piece;
    left.outline.edges.resize(part.outline.size());
    left.outline.corners = std::move(part.outline);
  }
  std::erase_if(out, [&](const FacadeShadow& left) { return is_filled(left, setting, spacing_m); });
  return out;
}

// Copies of repeated openings go into the faces; one after the other, so that one that does not fit between its
// neighbours is left out alone.
void add_copies(const PatternSetting& setting, const FillSetting& fill, VectorPlane& plane,
                FacadeWall& wall) {
  std::vector<FacadeOpening> before = wall.openings;
  if (!setting.enabled || complete_patterns(wall, setting) == 0) return;
  std::vector<FacadeOpening> kept = before;
  for (size_t i = 0; i < wall.openings.size(); ++i) {
    const FacadeOpening& copy = wall.openings[i];
    const bool is_new = i >= before.size();
    if (!is_new && copy.copied_from < 0) continue;
    if (copy.is_notch || (!is_new && before[i].is_notch))
      continue;  // a notch belongs to the outline
    std::vector<FacadeOpening> trial = kept;
    if (is_new) trial.push_back(copy);
    else trial[i] = copy;
    // What hid the opening left no data of about its size: the copy says what was there.
    std::vector<FacadeShadow> shadows;
    const RingBox place = ring_box(copy.outline);
    for (const FacadeShadow& shadow : wall.shadows) {
      if (shadow.is_filled || overlap(ring_box(shadow.outline), place) < kHiddenByCopy) {
        shadows.push_back(shadow);
        continue;
      }
      if (shadow.is_notch) continue;
      for (FacadeShadow& part : left_of(shadow, copy.outline, fill, plane.spacing_m))
        shadows.push_back(std::move(part));
    }
    std::vector<VectorFace> faces = faces_with(plane, shadows, trial);
    if (!is_sound(faces[copy.piece], kChordOfSpacing * plane.spacing_m)) continue;
    plane.faces = std::move(faces);
    kept = std::move(trial);
    wall.shadows = std::move(shadows);
  }
  wall.openings = std::move(kept);
}

}  // namespace

FacadePlan plan_facades(const Segmentation& segmentation, std::vector<VectorPlane> planes,
                        const PlanSetting& setting, Task& task,
                        std::span<const WallEvidence> evidence) {
  FacadePlan plan;
  plan.planes = std::move(planes);
  // 1. Facades and their walls.
  std::vector<WallClaim> claims;
  for (const WallEvidence& e : evidence)
    claims.push_back({e.role != PlaneRole::kWall, e.is_recess, e.has_framed_openings(), e.gross_m2,
                      e.measured_m2});
  for (FacadeGroup& group : group_facades(plan.planes, setting.group, claims))
    plan.facades.push_back({std::move(group), {}, {}});
  task.checkpoint(0.05);
  // 2. One look at the cloud for the holes of all walls.
  WallList list = list_walls(segmentation, plan, evidence, setting);
  std::vector<WallSurvey> surveys;
  {
    const ProgressSpan span(task, 0.05, 0.8, "looking through openings");
    surveys = survey_walls(segmentation, list.walls, setting.survey, task);
  }
  // 3. Openings, and what was not looked at.
  std::vector<uint64_t> in_openings(segmentation.segments.size() + 1, 0);
  size_t k = 0;
  for (PlannedFacade& facade : plan.facades)
    for (const size_t index : facade.group.walls) {
      task.checkpoint(0.8);
      end_at_sills(plan.planes, index, surveys[k], setting.survey.front_m, list.holes[k]);
      PlannedWall wall = planned_wall(segmentation, plan.planes[index], index);
      const auto opening_of = judge_holes(segmentation, list.holes[k], surveys[k], setting.survey,
                                          wall.wall, task, drawn_openings(evidence, index));
      count_points(opening_of, surveys[k], wall.wall, in_openings);
      fill_shadows(setting.fill, plan.planes[index], wall.wall);
      add_copies(setting.patterns, setting.fill, plan.planes[index], wall.wall);
      facade.walls.push_back(std::move(wall));
      ++k;
    }
  // 4. What is left: planes that are neither walls nor in their openings.
  for (PlannedFacade& facade : plan.facades)
    for (const size_t index : facade.group.others) {
      const Segment& segment = segmentation.segments[index];
      if (static_cast<double>(in_openings[segment.label]) <
          kConsumedShare * static_cast<double>(segment.point_count()))
        facade.elements.push_back(index);
    }
  // 5. What the openings are.
  classify_openings(setting.classes, plan);
  return plan;
}

}  // namespace jalon
