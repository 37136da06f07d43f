// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/coarse.h"

#include <algorithm>
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

constexpr double kFeatureRadius =
    5;  // cells (Rusu et al. 2009: a few times the radius of the normals)
constexpr size_t kDistinctPoints = 4000;
constexpr size_t kCoarseLeastCells = 50;  // fewer show no shape
constexpr double kLevel =
    0.9962;  // cosine, 5 degrees: of what stands upright, before fine registration
// Salient places near the other cloud: few of them, all in one corner, look alike anywhere. Scans of different places
// came to 0.05, of the same place to 0.6 and more.
constexpr double kLeastSalient = 0.1;
constexpr double kWhole =
    0.8;  // overlap of both clouds that needs no salient places to be believed
// Score of the second pose, of the best one's, at which the best stands out of nothing: of 30 pairs of scans of
// different buildings 0.61 to 1.
constexpr double kNoLead = 0.6;

Transform shift_by(const Vec3& shift) { return motion_about({}, {}, shift); }

/// Where the surfaces' own frames begin, in the caller's coordinates: poses between these, and
/// between the clouds.
struct Frames {
  Vec3 reference, moving;
  Transform to_world(const Transform& T_reference_moving) const {
    return shift_by(reference) * T_reference_moving * shift_by(-moving);
  }
  Transform to_local(const Transform& T_reference_moving_world) const {
    return shift_by(-reference) * T_reference_moving_world * shift_by(moving);
  }
};

CoarseSurface described(const Cloud& cloud, double cell_m, const char* which, Task& task) {
  CoarseSurface surface = coarse_surface(cloud, cell_m, task);
  if (surface.size() < kCoarseLeastCells)
    fail(Status::kInsufficientData,
         "the %s cloud fills only %zu cells; coarse registration needs %zu", which, surface.size(),
         kCoarseLeastCells);
  describe_features(surface, kFeatureRadius * cell_m, kDistinctPoints, task);
  return surface;
}

// T_start, like the poses asked about, between the surfaces' own frames.
PoseFilter filter_of(const CoarseSettings& settings, const Transform& T_start,
                     const Vec3& centroid) {
  const bool level = settings.gravity;
  const double turn = settings.max_turn_rad, shift = settings.max_shift_m;
  return [=](const Transform& T_reference_moving) {
    if (level && T_reference_moving.m[10] < kLevel) return false;
    const Transform away = T_reference_moving * inverse(T_start);
    if (turn < std::numbers::pi && norm(rotation_vector(away)) > turn) return false;
    const Vec3 to = T_reference_moving.point(centroid);
    return shift <= 0 || norm(to - T_start.point(centroid)) <= shift;
  };
}

// Of the salient places, the share that must look alike: the less, the farther the best pose stands out of the others.
double least_likeness(const std::vector<RankedPose>& poses, const CoarseSettings& settings) {
  const double whole = settings.min_likeness_percent / 100;
  if (poses.size() < 2 || !(poses[0].overlap.score() > 0)) return whole;
  const double second = poses[1].overlap.score() / poses[0].overlap.score();
  return whole * std::min(1.0, second / kNoLead);
}

StopReason verdict(const std::vector<RankedPose>& poses, const CoarseSettings& settings) {
  if (poses.empty()) return StopReason::kNothingFound;
  const SurfaceOverlap& best = poses[0].overlap;
  const bool is_whole = best.count >= kWhole;
  const double least_common = settings.min_common_percent / 100;
  if (best.of_moving < least_common || (!is_whole && best.salient < kLeastSalient))
    return StopReason::kNothingFound;
  if (!is_whole && best.likeness < least_likeness(poses, settings))
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
                             const Transform& T_start, const CoarseSettings& settings, Task& task) {
  if (reference->size() < kCoarseLeastCells || moving->size() < kCoarseLeastCells)
    fail(Status::kInsufficientData, "coarse registration needs %zu points in each cloud",
         kCoarseLeastCells);
  // 1. Surfaces.
  CoarseSurface reference_surface, moving_surface;
  {
    const ProgressSpan span(task, 0, 0.2, "thinning");
    const double cell_m = cell_of(*reference, *moving, settings, task);
    reference_surface = described(*reference, cell_m, "reference", task);
    moving_surface = described(*moving, cell_m, "moving", task);
  }
  const Frames frames{reference_surface.origin, moving_surface.origin};
  const Transform T_start_local = frames.to_local(T_start);
  // 2. Candidates.
  std::vector<PoseCandidate> candidates{{T_start_local, PoseSource::kStart}};
  {
    const ProgressSpan span(task, 0.2, 0.5, nullptr);
    const auto made = coarse_candidates(reference_surface, moving_surface, settings.gravity, task);
    candidates.insert(candidates.end(), made.begin(), made.end());
  }
  // 3. The best of them.
  const ProgressSpan span(task, 0.5, 1, nullptr);
  const PoseFilter is_wanted = filter_of(settings, T_start_local, moving_surface.centroid);
  CoarseSearch found = search_poses(reference_surface, moving_surface, candidates, is_wanted, task);
  // 4. Is it the only one?
  Registration out;
  out.stopped = verdict(found.poses, settings);
  out.converged = out.stopped == StopReason::kConverged;
  for (RankedPose& pose : found.poses)
    pose.T_reference_moving = frames.to_world(pose.T_reference_moving);
  const bool has_pose = out.stopped != StopReason::kNothingFound;
  out.pose = has_pose ? found.poses[0].T_reference_moving : T_start;
  out.centre = out.pose.point(moving_surface.centroid + moving_surface.origin);
  out.extent_m = moving_surface.extent_m;
  fill_coarse_tables(out, found, reference_surface.cell_m, candidates.size());
  return out;
}

}  // namespace jalon
