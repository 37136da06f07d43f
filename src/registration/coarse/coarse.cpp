// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/coarse.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "registration/coarse/feature_histogram.h"
#include "registration/coarse/rows.h"
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

PoseFilter filter_of(const CoarseSettings& settings, const Transform& start, const Vec3& centroid) {
  const bool level = settings.gravity;
  const double turn = settings.max_turn_rad, shift = settings.max_shift_m;
  return [=](const Transform& pose) {
    if (level && pose.m[10] < kLevel) return false;
    if (turn < std::numbers::pi && norm(rotation_vector(pose * inverse(start))) > turn) return false;
    return shift <= 0 || norm(pose.point(centroid) - start.point(centroid)) <= shift;
  };
}

StopReason verdict(const std::vector<RankedPose>& poses, const CoarseSettings& settings) {
  if (poses.empty()) return StopReason::kNothingFound;
  const Overlap& best = poses[0].overlap;
  const bool is_whole = best.count >= kWhole;
  const double least_common = settings.min_common_percent / 100;
  if (best.of_moving < least_common || (!is_whole && best.salient < kLeastSalient)) return StopReason::kNothingFound;
  if (!is_whole && 100 * best.likeness < settings.min_likeness_percent)
    return StopReason::kNothingFound;
  const bool has_rival = poses.size() > 1 && 100 * poses[1].overlap.score() >=
                                                 settings.ambiguous_percent * best.score();
  return has_rival ? StopReason::kAmbiguous : StopReason::kConverged;
}

double cell_of(const Cloud& reference, const Cloud& moving, const CoarseSettings& settings,
               Task& task) {
  const double given = settings.coarse_cell_m;
  const double cell = given > 0 ? given : coarse_cell(reference, moving, settings.cells, task);
  if (!(cell > 0)) fail(Status::kInsufficientData, "all points of a cloud lie at one place");
  return cell;
}

}  // namespace

std::span<const ParamRow> coarse_rows() { return kCoarseRows; }

Registration register_coarse(const CloudPtr& reference, const CloudPtr& moving,
                             const Transform& start, const CoarseSettings& settings, Task& task) {
  if (reference->size() < kLeastCells || moving->size() < kLeastCells)
    fail(Status::kInsufficientData, "coarse registration needs %zu points in each cloud", kLeastCells);
  // 1. Surfaces.
  CoarseSurface to, from;
  {
    const Span span(task, 0, 0.2, "thinning");
    const double cell_m = cell_of(*reference, *moving, settings, task);
    to = described(*reference, cell_m, "reference", task);
    from = described(*moving, cell_m, "moving", task);
  }
  const Frames frames{to.origin, from.origin};
  const Transform local_start = frames.to_local(start);
  // 2. Candidates.
  std::vector<PoseCandidate> candidates{{local_start, PoseSource::kStart}};
  {
    const Span span(task, 0.2, 0.5, nullptr);
    const auto made = coarse_candidates(to, from, settings.gravity, task);
    candidates.insert(candidates.end(), made.begin(), made.end());
  }
  // 3. The best of them.
  const Span span(task, 0.5, 1, nullptr);
  CoarseSearch found =
      search_poses(to, from, candidates, filter_of(settings, local_start, from.centroid), task);
  // 4. Is it the only one?
  Registration out;
  out.stopped = verdict(found.poses, settings);
  out.converged = out.stopped == StopReason::kConverged;
  out.pose = out.stopped == StopReason::kNothingFound ? start : frames.to_world(found.poses[0].pose);
  out.centre = out.pose.point(from.centroid + from.origin);
  out.extent_m = from.extent_m;
  for (RankedPose& pose : found.poses) pose.pose = frames.to_world(pose.pose);
  fill_coarse_tables(out, found, to.cell_m, candidates.size());
  return out;
}

}  // namespace jalon
