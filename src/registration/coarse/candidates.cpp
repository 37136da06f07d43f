// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/candidates.h"

#include "registration/coarse/feature_match.h"
#include "registration/coarse/graph.h"
#include "registration/coarse/plane_match.h"
#include "registration/coarse/planes.h"
#include "registration/coarse/pose.h"

namespace jalon {

namespace {

constexpr size_t kRank =
    2;  // mutual neighbours in feature space: the right one is often the second
constexpr size_t kMostMatches = 3000;  // vertices of the graph
constexpr double kRigid =
    1.5;  // cells: centroids of cells of two grids lie off by about half a cell each
constexpr double kApart = 5;  // cells: places nearer to each other say nothing about a turn
constexpr size_t kCliques = 60, kLeastClique = 4;
constexpr size_t kPlanes = 14;     // of each cloud
constexpr size_t kRotations = 32;  // 24 of a scene of right angles and some to spare
constexpr size_t kPosesOfRotation = 8;

void add_from_features(const CoarseSurface& reference, const CoarseSurface& moving,
                       const std::vector<FeatureMatch>& matches, Task& task,
                       std::vector<PoseCandidate>& out) {
  const MatchGraph graph(matches, reference, moving, kRigid * reference.cell_m,
                         kApart * reference.cell_m, task);
  for (const std::vector<uint32_t>& clique : graph.cliques(kCliques, kLeastClique, task)) {
    std::vector<Vec3> from, to;
    for (const uint32_t i : clique) {
      from.push_back(moving.points[matches[i].moving]);
      to.push_back(reference.points[matches[i].reference]);
    }
    out.push_back({closest_motion(from, to), PoseSource::kFeatures});
  }
}

void add_from_planes(const CoarseSurface& reference, const CoarseSurface& moving,
                     const std::vector<FeatureMatch>& matches, bool level, Task& task,
                     std::vector<PoseCandidate>& out) {
  const std::vector<CoarsePlane> to = coarse_planes(reference, kPlanes, task);
  const std::vector<CoarsePlane> from = coarse_planes(moving, kPlanes, task);
  const PlaneSets sets{to, from, level};
  for (const Transform& T_reference_moving : poses_of_largest(sets, reference, moving))
    out.push_back({T_reference_moving, PoseSource::kPlanes});
  for (const Transform& rotation : plane_rotations(sets, kRotations, task))
    for (const Transform& T_reference_moving :
         plane_poses(rotation, sets, reference, moving, matches, kPosesOfRotation))
      out.push_back({T_reference_moving, PoseSource::kPlanes});
}

}  // namespace

std::vector<PoseCandidate> coarse_candidates(const CoarseSurface& reference,
                                             const CoarseSurface& moving, bool level, Task& task) {
  std::vector<FeatureMatch> matches;
  std::vector<PoseCandidate> out;
  {
    const ProgressSpan span(task, 0, 0.7, "matching features");
    matches = match_features(reference, moving, kRank, kMostMatches, task);
    add_from_features(reference, moving, matches, task, out);
  }
  const ProgressSpan span(task, 0.7, 1, "matching planes");
  add_from_planes(reference, moving, matches, level, task, out);
  return out;
}

}  // namespace jalon
