// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/search.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "registration/symmetric_eigen6.h"

namespace jalon {

namespace {

constexpr size_t kFewPoints = 400, kMorePoints = 1000, kManyPoints = 6000;  // of each surface
constexpr double kLooseReach = 2, kLooseOffPlane = 1;        // cells: before poses have settled
constexpr double kSearchReach = 1.5, kSearchOffPlane = 0.5;  // cells: once they have
constexpr double kFirstReach = 4, kLastReach = 1.2;          // cells, of the iterations
constexpr int kIterations = 14, kLastIterations = 8;
constexpr size_t kSettled = 40, kRivals = 8;  // poses that are settled, and judged in the end
constexpr double kSamePose = 1;               // cells: two candidates this near settle alike
constexpr double kOtherPose = 4;  // cells: settled poses this far from each other are two
constexpr double kSlide = 8;      // cells

// Curved ground can be laid across other ground, salient places and all; but then it crosses it, and what counts as
// common is spread over the half cell that it may be off: 0.2 to 0.3 cells, 2.2 to 3.4 times the scatter of the cells
// about their own planes. Surfaces that are the same stay below 0.14 cells, or, where they are rough, 1.3 times that.
constexpr double kCrossCells = 0.17, kCrossScatters = 1.7;

using Poses = std::vector<RankedPose>;

bool crosses(const RankedPose& pose, double cell_m) {
  return pose.overlap.rms_m > kCrossCells * cell_m &&
         pose.overlap.rms_m > kCrossScatters * pose.overlap.scatter_m;
}

void rank(Poses& poses) {
  std::stable_sort(poses.begin(), poses.end(), [](const RankedPose& a, const RankedPose& b) {
    return a.overlap.score() > b.overlap.score();
  });
}

// The best of each group of poses within a distance, at most this many.
Poses distinct(const Poses& poses, const PoseJudge& judge, double distance_m, size_t most) {
  Poses out;
  for (const RankedPose& pose : poses) {
    if (out.size() == most) break;
    const bool is_new = std::none_of(out.begin(), out.end(), [&](const RankedPose& other) {
      return judge.difference(pose.T_reference_moving, other.T_reference_moving) <= distance_m;
    });
    if (is_new) out.push_back(pose);
  }
  return out;
}

void settle(Poses& poses, const PoseJudge& judge, double first_reach, int iterations, Task& task) {
  parallel_for(task, poses.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      Transform& T_reference_moving = poses[i].T_reference_moving;
      T_reference_moving =
          judge.settled(T_reference_moving, first_reach, kLastReach, iterations).T_reference_moving;
      poses[i].overlap = judge.overlap(T_reference_moving, kSearchReach, kSearchOffPlane);
    }
  });
}

// Step 1.
Poses first_look(const PoseJudge& judge, const std::vector<PoseCandidate>& candidates,
                 const PoseFilter& is_wanted, Task& task) {
  Poses out;
  for (const PoseCandidate& candidate : candidates)
    if (is_wanted(candidate.T_reference_moving))
      out.push_back({candidate.T_reference_moving, candidate.source, {}});
  parallel_for(task, out.size(), 4, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      out[i].overlap = judge.overlap(out[i].T_reference_moving, kLooseReach, kLooseOffPlane);
  });
  rank(out);
  return out;
}

// Step 3: both ways along the three weakest of the six directions, turns and shifts made alike by the extent.
Poses slides(const RankedPose& best, const Square<6>& fixed, const CoarseSurface& moving) {
  const Eigen6 eigen = symmetric_eigen(fixed, 1 / moving.extent_m);
  const Vec3 centre = best.T_reference_moving.point(moving.centroid);
  Poses out;
  for (size_t weak = 0; weak < 3; ++weak)
    for (const double way : {-kSlide * moving.cell_m, kSlide * moving.cell_m}) {
      const Coefficients<6>& d = eigen.vectors[weak];
      const Vec3 turn = Vec3{d[0], d[1], d[2]} * (way / moving.extent_m);
      const Vec3 shift = Vec3{d[3], d[4], d[5]} * way;
      const Transform slide = motion_about(centre, turn, shift);
      out.push_back({slide * best.T_reference_moving, PoseSource::kSlide, {}});
    }
  return out;
}

}  // namespace

CoarseSearch search_poses(const CoarseSurface& reference, const CoarseSurface& moving,
                          const std::vector<PoseCandidate>& candidates, const PoseFilter& is_wanted,
                          Task& task) {
  const double cell_m = reference.cell_m;
  const PoseJudge few(reference, moving, kFewPoints), more(reference, moving, kMorePoints),
      many(reference, moving, kManyPoints);
  const auto unwanted = [&](const RankedPose& p) {
    return !is_wanted(p.T_reference_moving) || crosses(p, cell_m);
  };
  CoarseSearch out;
  Poses poses;
  {
    // Steps 1 and 2.
    const ProgressSpan span(task, 0, 0.6, "settling poses");
    poses =
        distinct(first_look(few, candidates, is_wanted, task), few, kSamePose * cell_m, kSettled);
    settle(poses, more, kFirstReach, kIterations, task);
    std::erase_if(poses, unwanted);
    rank(poses);
    poses = distinct(poses, more, kOtherPose * cell_m, kRivals);
  }
  if (poses.empty()) return out;
  // Step 2 again, on many points.
  const ProgressSpan span(task, 0.6, 1, "judging poses");
  settle(poses, many, kSearchReach, kLastIterations, task);
  std::erase_if(poses, unwanted);
  if (poses.empty()) return out;
  rank(poses);
  const SettledPose settled =
      many.settled(poses.front().T_reference_moving, kSearchReach, kLastReach, kLastIterations);
  poses.front().T_reference_moving = settled.T_reference_moving;
  out.fixed = settled.fixed;
  // Steps 3 and 4. The best may be found again by a slide; then it keeps its source.
  const RankedPose best = poses.front();
  Poses moved = slides(best, out.fixed, moving);
  settle(moved, more, kFirstReach, kIterations, task);
  settle(moved, many, kSearchReach, kLastIterations, task);
  poses.insert(poses.end(), moved.begin(), moved.end());
  std::erase_if(poses, unwanted);
  rank(poses);
  RankedPose& first = poses.front();
  const double apart_m = many.difference(first.T_reference_moving, best.T_reference_moving);
  if (apart_m <= kOtherPose * cell_m) first.source = best.source;
  out.poses = distinct(poses, many, kOtherPose * cell_m, kRivals);
  return out;
}

}  // namespace jalon
