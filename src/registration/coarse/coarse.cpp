// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/coarse.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "registration/coarse/feature_histogram.h"
#include "registration/coarse/search.h"
#include "registration/coarse/tables.h"

namespace jalon {

namespace {

constexpr double kFeatureRadius = 5;     // cells (Rusu et al. 2009: a few times the radius of the normals)
constexpr size_t kDistinctPoints = 4000;
constexpr size_t kLeastCells = 50;       // fewer show no shape
constexpr double kLevel = 0.9962;        // cosine, 5 degrees: of what stands upright, before fine registration
// Salient places near the other cloud: few of them, all in one corner, look alike anywhere. Scans of different places
// came to 0.05, of the same place to 0.6 and more.
constexpr double kLeastSalient = 0.1;
constexpr double kWhole = 0.8;           // overlap of both clouds that needs no salient places to be believed

constexpr ParamRow kRows[] = {
    number_row("coarse_cell_m", 0, 0, 1e4, "m", "",
               "Edge of the cells that both clouds are thinned to; 0 = so that the larger has about `cells` of them"),
    integer_row("cells", 15000, 500, 200000, "", "",
                "Cells of the larger cloud, for coarse_cell_m = 0; more is slower"),
    bool_row("gravity", false, "", "z is up in both clouds, as of levelled scanners: only turns about it are found"),
    number_row("max_turn_rad", std::numbers::pi, 0, 3.2, "rad", "", "Largest turn away from the start pose"),
    number_row("max_shift_m", 0, 0, 1e9, "m", "",
               "Largest shift of the moving cloud's centroid away from where the start pose puts it; 0 = any"),
    number_row("ambiguous_percent", 85, 1, 100, "%", "",
               "Score of a clearly different pose, of the best one's, from which the result is called ambiguous"),
    number_row("min_likeness_percent", 62, 0, 100, "%", "",
               "Of the salient places that come near the other cloud, the share that must look alike there; with less "
               "nothing is found (unless the clouds cover each other almost whole)"),
    number_row("min_common_percent", 5, 0, 100, "%", "",
               "Share of the moving cloud's surface that must lie on the reference; with less nothing is found"),
};

Transform shift_by(const Vec3& shift) { return motion_about({}, {}, shift); }

/// Between poses of the clouds and poses of their surfaces' own frames.
struct Frames {
  Vec3 reference, moving;
  Transform to_world(const Transform& local) const { return shift_by(reference) * local * shift_by(-moving); }
  Transform to_local(const Transform& world) const { return shift_by(-reference) * world * shift_by(moving); }
};

CoarseSurface described(const Cloud& cloud, double cell_m, const char* which, Task& task) {
  CoarseSurface surface = coarse_surface(cloud, cell_m, task);
  if (surface.size() < kLeastCells)
    fail(Status::kInsufficientData, "the %s cloud fills only %zu cells; coarse registration needs %zu", which,
         surface.size(), kLeastCells);
  describe_features(surface, kFeatureRadius * cell_m, kDistinctPoints, task);
  return surface;
}

PoseFilter filter_of(const ParamSet& params, const Transform& start, const Vec3& centroid) {
  const bool level = params.flag("gravity");
  const double turn = params.number("max_turn_rad"), shift = params.number("max_shift_m");
  return [=](const Transform& pose) {
    if (level && pose.m[10] < kLevel) return false;
    if (turn < std::numbers::pi && norm(rotation_vector(pose * inverse(start))) > turn) return false;
    return shift <= 0 || norm(pose.point(centroid) - start.point(centroid)) <= shift;
  };
}

StopReason verdict(const std::vector<RankedPose>& poses, const ParamSet& params) {
  if (poses.empty()) return StopReason::kNothingFound;
  const Overlap& best = poses[0].overlap;
  const bool is_whole = best.count >= kWhole;
  const double least_common = params.number("min_common_percent") / 100;
  if (best.of_moving < least_common || (!is_whole && best.salient < kLeastSalient)) return StopReason::kNothingFound;
  if (!is_whole && 100 * best.likeness < params.number("min_likeness_percent")) return StopReason::kNothingFound;
  const bool has_rival =
      poses.size() > 1 && 100 * poses[1].overlap.score() >= params.number("ambiguous_percent") * best.score();
  return has_rival ? StopReason::kAmbiguous : StopReason::kConverged;
}

double cell_of(const Cloud& reference, const Cloud& moving, const ParamSet& params, Task& task) {
  const double given = params.number("coarse_cell_m");
  const double cell =
      given > 0 ? given : coarse_cell(reference, moving, static_cast<size_t>(params.integer("cells")), task);
  if (!(cell > 0)) fail(Status::kInsufficientData, "all points of a cloud lie at one place");
  return cell;
}

}  // namespace

std::span<const ParamRow> coarse_rows() { return kRows; }

Registration register_coarse(const CloudPtr& reference, const CloudPtr& moving, const Transform& start,
                             const ParamSet& params, Task& task) {
  if (reference->size() < kLeastCells || moving->size() < kLeastCells)
    fail(Status::kInsufficientData, "coarse registration needs %zu points in each cloud", kLeastCells);
  // 1. Surfaces.
  CoarseSurface to, from;
  {
    const Span span(task, 0, 0.2, "thinning");
    const double cell_m = cell_of(*reference, *moving, params, task);
    to = described(*reference, cell_m, "reference", task);
    from = described(*moving, cell_m, "moving", task);
  }
  const Frames frames{to.origin, from.origin};
  const Transform local_start = frames.to_local(start);
  // 2. Candidates.
  std::vector<PoseCandidate> candidates{{local_start, PoseSource::kStart}};
  {
    const Span span(task, 0.2, 0.5, nullptr);
    const auto made = coarse_candidates(to, from, params.flag("gravity"), task);
    candidates.insert(candidates.end(), made.begin(), made.end());
  }
  // 3. The best of them.
  const Span span(task, 0.5, 1, nullptr);
  CoarseSearch found = search_poses(to, from, candidates, filter_of(params, local_start, from.centroid), task);
  // 4. Is it the only one?
  Registration out;
  out.stopped = verdict(found.poses, params);
  out.converged = out.stopped == StopReason::kConverged;
  out.pose = out.stopped == StopReason::kNothingFound ? start : frames.to_world(found.poses[0].pose);
  out.centre = out.pose.point(from.centroid + from.origin);
  out.extent_m = from.extent_m;
  for (RankedPose& pose : found.poses) pose.pose = frames.to_world(pose.pose);
  fill_coarse_tables(out, found, to.cell_m, candidates.size());
  return out;
}

}  // namespace jalon
