// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/openings.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "modelling/plane/ring_tools.h"
#include "modelling/walls/bays.h"
#include "modelling/walls/border_evidence.h"
#include "modelling/walls/evident_holes.h"
#include "modelling/walls/joinery.h"
#include "modelling/walls/leaf_foot.h"
#include "modelling/walls/opening_content.h"

namespace jalon {

namespace {

// Shares of a hole's cells.
constexpr double kThroughShare = 0.05;  // seen through: glass gives few returns, frames are narrow
constexpr uint32_t kThroughCells = 4;
constexpr double kHiddenShare = 0.25;  // hidden: rays to the rest went astray
constexpr double kFlushShare = 0.5;    // filled by something on or close before the wall
// A shutter and its hinges; what stands farther before the wall (a drainpipe with a canopy) hides it.
constexpr double kShutter_m = 0.12;
// Points of a plane upright to the wall before it counts as a reveal.
constexpr size_t kRevealPoints = 10;
constexpr size_t kDepthPoints = 10;  // behind an opening for a depth without a plane
// Doors: a leaf of 2 m less what a plinth or a step hides.
constexpr double kDoorHeight_m = 1.8, kDoorLeast_m = 0.6, kDoorMost_m = 3.5, kDoorFoot_m = 0.4;
constexpr double kWindowLeast_m = 0.25, kWindowMost_m = 5;
// By shape alone: the share of its upright box that an opening fills (a semicircle fills pi / 4 of its own).
constexpr double kBoxShare = 0.75;
constexpr size_t kMostCorners = 8;
constexpr double kMostSlender =
    4;  // longer side in shorter ones: strips are gutters and boards that were cut out
// The foot of a door lies this much below the wall's border before it is drawn there.
constexpr double kFootStep_m = 0.05;

bool has_shape_of_opening(const VectorRing& outline) {
  const RingBox box = ring_box(outline);
  const double least = std::min(box.width(), box.height()),
               most = std::max(box.width(), box.height());
  return outline.corners.size() <= kMostCorners && least >= kWindowLeast_m &&
         most <= std::min(kWindowMost_m, kMostSlender * least) &&
         signed_area(outline) >= kBoxShare * box.width() * box.height();
}

struct Verdict {
  bool is_opening = false;
  Evidence evidence = Evidence::kNone;
};

Verdict judge(const WallHole& hole, const HoleSurvey& survey, const HoleContent& content,
              const HoleFiller* joinery, double tolerance_m) {
  const auto share = [&](uint32_t cells) {
    return cells / std::max(1.0, static_cast<double>(survey.cells));
  };
  const bool is_seen = survey.through >= kThroughCells && share(survey.through) >= kThroughShare;
  const bool is_revealed = std::any_of(
      content.upright.begin(), content.upright.end(),
      [&](const HoleFiller& f) { return f.points >= kRevealPoints && f.depth_m > tolerance_m; });
  if (is_seen || joinery != nullptr)
    return {true, is_revealed ? Evidence::kRevealed : Evidence::kSeenBehind};
  if (!content.parallel.empty() && share(content.parallel.front().cells) >= kFlushShare)
    return content.parallel.front().depth_m >= -kShutter_m ? Verdict{true, Evidence::kMeasured}
                                                           : Verdict{};
  if (share(survey.hidden) >= kHiddenShare) return {};
  if (is_revealed) return {true, Evidence::kRevealed};
  return {has_shape_of_opening(hole.outline), Evidence::kShape};
}

// The wall was drawn by its evidence: a hole is what the candidate is that it was drawn for.
Verdict by_candidates(const Verdict& verdict, const WallHole& hole,
                      std::span<const OpeningCandidate> candidates) {
  if (candidate_of(hole, candidates) < 0) return {};
  return verdict.is_opening ? verdict : Verdict{true, Evidence::kShape};
}

OpeningKind kind_of(const RingBox& box, bool reaches_ground, const FacadeOpening& opening) {
  if (reaches_ground && box.height() >= kDoorHeight_m && box.width() >= kDoorLeast_m &&
      box.width() <= kDoorMost_m)
    return OpeningKind::kDoor;
  const double least = std::min(box.width(), box.height()),
               most = std::max(box.width(), box.height());
  if (least < kWindowLeast_m || most > kWindowMost_m) return OpeningKind::kOpening;
  const bool is_filled = opening.joinery_label != 0 || opening.evidence == Evidence::kShape;
  return is_filled ? OpeningKind::kWindow : OpeningKind::kOpening;
}

// Where no plane fills the opening: the middle one of what lies behind it (leaves ajar, goods in a shop window); NaN
// when nothing does.
double depth_of_points(const HoleSurvey& survey, double tolerance_m) {
  std::vector<double> depths;
  for (const HolePoint& p : survey.points)
    if (p.w < -tolerance_m) depths.push_back(-p.w);
  if (depths.size() < kDepthPoints) return kNaN;
  const auto middle = depths.begin() + static_cast<ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

void measure_depth(const HoleContent& content, const HoleFiller* joinery,
                   const Segmentation& segmentation, const HoleSurvey& survey, double tolerance_m,
                   FacadeOpening& opening) {
  const HoleFiller* filler = joinery;
  if (filler == nullptr && opening.evidence == Evidence::kMeasured)
    filler = &content.parallel.front();
  if (filler == nullptr) {
    opening.depth_m = depth_of_points(survey, tolerance_m);
    return;
  }
  const Segment& segment = segmentation.segments[filler->label - 1];
  opening.joinery_label = filler->label;
  opening.depth_m = filler->depth_m;
  opening.depth_sigma_m = std::sqrt(std::max(0.0, segment.fit.local_covariance[5]));
}

// A leaf that goes on below the wall's border (a plinth stands before it, or the wall's foot was not seen) takes the
// opening down to its own foot; the wall's corners stay.
void lower_to(double foot_v, VectorRing& outline) {
  const Vec2 left = outline.corners[0], right = outline.corners[1];
  if (foot_v > std::min(left.v, right.v) - kFootStep_m) return;
  VectorEdge jamb;
  jamb.direction = EdgeDirection::kVertical;
  VectorEdge foot;
  foot.direction = EdgeDirection::kHorizontal;
  outline.corners.insert(outline.corners.begin() + 1, {{left.u, foot_v}, {right.u, foot_v}});
  outline.edges.erase(outline.edges.begin());
  outline.edges.insert(outline.edges.begin(), {jamb, foot, jamb});
}

}  // namespace

std::vector<int32_t> judge_holes(const Segmentation& segmentation, std::span<const WallHole> holes,
                                 WallSurvey& survey, const SurveySetting& setting, FacadeWall& wall,
                                 Task& task, std::span<const OpeningCandidate> candidates) {
  wall.map = std::move(survey.map);
  std::vector<int32_t> opening_of(holes.size(), -1);
  for (size_t h = 0; h < holes.size(); ++h) {
    task.checkpoint(0);
    WallHole hole = holes[h];
    const HoleSurvey& seen = survey.holes[h];
    if (hole.is_bay && !hole.is_evident && candidates.empty() &&
        !fit_to_content(hole, seen, wall.map, survey.tolerance_m))
      continue;
    const HoleContent content =
        content_of(seen, wall.map, segmentation, wall.frame.normal, wall.label, task);
    Joinery closing = joinery_of(content, setting.min_depth_m);
    const HoleFiller* joinery = closing.filler;
    Verdict verdict = judge(hole, seen, content, joinery, survey.tolerance_m);
    if (!candidates.empty()) verdict = by_candidates(verdict, hole, candidates);
    else if (hole.is_evident && !verdict.is_opening) verdict = {true, Evidence::kShape};
    if (!verdict.is_opening) {
      wall.shadows.push_back({hole.outline, hole.piece, hole.is_notch});
      continue;
    }
    FacadeOpening opening;
    opening.outline = hole.outline;
    opening.piece = hole.piece;
    opening.is_notch = hole.is_notch;
    opening.ends_at_sill = hole.ends_at_sill;
    opening.evidence = verdict.evidence;
    measure_depth(content, joinery, segmentation, seen, survey.tolerance_m, opening);
    opening.standing_labels = std::move(closing.standing);
    std::erase(opening.standing_labels, opening.joinery_label);
    measure_border(wall, seen, opening);
    const double foot = ring_box(wall.outlines[hole.piece]).low.v;
    if (hole.is_notch && joinery != nullptr)
      lower_to(leaf_foot(seen, joinery->label, opening.outline), opening.outline);
    opening.content = opening_content(seen, wall.map, opening, survey.tolerance_m);
    const RingBox box = ring_box(opening.outline);
    const bool is_below = hole.is_notch && !hole.is_bay;  // nothing of the wall is
    opening.kind = kind_of(box, is_below || box.low.v <= foot + kDoorFoot_m, opening);
    opening_of[h] = static_cast<int32_t>(wall.openings.size());
    wall.openings.push_back(std::move(opening));
  }
  return opening_of;
}

}  // namespace jalon
