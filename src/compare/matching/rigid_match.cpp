// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/matching/rigid_match.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "compare/matching/match_starts.h"
#include "geometry/adjustment.h"
#include "geometry/rigid_motion.h"

namespace jalon {

namespace {

constexpr size_t kSample = 1500;  // points of the iterations
constexpr int kIterations = 40;
constexpr double kShrink = 0.8;  // of the reach, each iteration
constexpr double kDiscs = 4;  // points within so many of their discs' radii belong to one surface
constexpr double kDamping = 1e-6;  // keeps directions that nothing fixes where they are
constexpr double kEqual =
    0.02;  // shares that differ by less are chance: a box turned half round fits as well
// Of the tolerance: a step by less changes no pair.
constexpr double kSmallStep = 0.01;
constexpr int kRefinements = 4;
constexpr size_t kPairGrain = 256;  // points, each of which is a search
constexpr size_t kLeastPairs = 12;  // two for each unknown

// Is the moved point on the surface? The pair is its plane there. flat: only away from edges, where planes are true.
bool lies_on(const MatchSurface& surface, const Vec3& moved, double reach_m, PlanePair& pair,
             bool flat = false) {
  const Neighbour near = surface.nearest(moved);
  if (flat && !surface.is_flat(near.index)) return false;
  const double discs = kDiscs * surface.radius(near.index);
  if (near.squared_distance > (reach_m + discs) * (reach_m + discs)) return false;
  pair.to = surface.points()[near.index];
  pair.normal = surface.normal(near.index);
  return squared_norm(pair.normal) > 0 && std::abs(dot(pair.normal, moved - pair.to)) <= reach_m;
}

// Step 2: one iteration, by how far it moved what is size_m large; negative when too few points meet.
double iterate(const std::vector<Vec3>& sample, const MatchSurface& after, double reach_m,
               double size_m, MotionModel& model) {
  constexpr double kNone = -1;
  Square<6> normal{};
  Coefficients<6> right{}, j;
  size_t n = 0;
  for (const Vec3& p : sample) {
    PlanePair pair{p, {}, {}};
    if (!lies_on(after, model.motion().point(p), reach_m, pair)) continue;
    const double d = model.residual(pair, j);
    ++n;
    for (size_t r = 0; r < 6; ++r) {
      right[r] -= d * j[r];
      for (size_t c = 0; c < 6; ++c) normal[6 * r + c] += j[r] * j[c];
    }
  }
  if (n < kLeastPairs) return kNone;
  double trace_turn = 0, trace_shift = 0;
  for (size_t i = 0; i < 3; ++i) {
    trace_turn += normal[7 * i];
    trace_shift += normal[7 * (i + 3)];
  }
  for (size_t i = 0; i < 6; ++i) normal[7 * i] += kDamping * (i < 3 ? trace_turn : trace_shift);
  Cholesky<6> factor;
  if (!factor.factor(normal)) return kNone;
  const Coefficients<6> step = factor.solve(right);
  model.move(step);
  return norm(Vec3{step[0], step[1], step[2]}) * size_m / 2 + norm(Vec3{step[3], step[4], step[5]});
}

Transform iterated(const std::vector<Vec3>& sample, const MatchSurface& before,
                   const MatchSurface& after, const Transform& start, double tolerance_m,
                   Task& task) {
  MotionModel model(start, before.centroid());
  const double size_m = norm(before.box().max - before.box().min);
  double reach_m = std::max(size_m / 4, tolerance_m);
  for (int k = 0; k < kIterations; ++k) {
    task.checkpoint(0);
    const double step_m = iterate(sample, after, reach_m, size_m, model);
    if (step_m < 0 || (reach_m <= tolerance_m && step_m < kSmallStep * tolerance_m)) break;
    reach_m = std::max(reach_m * kShrink, tolerance_m);
  }
  return model.motion();
}

double explained_by(const Transform& motion, const std::vector<Vec3>& of_before,
                    const std::vector<Vec3>& of_after, const MatchSurface& before,
                    const MatchSurface& after, const MatchSetting& setting, Task& task) {
  const LaidOn forth =
      laid_on(of_before, motion, after, setting.seen_after, setting.tolerance_m, task);
  const LaidOn back =
      laid_on(of_after, inverse(motion), before, setting.seen_before, setting.tolerance_m, task);
  // Where most of it could not have been seen, nothing says that it is there.
  const auto is_judged = [&](const LaidOn& share, size_t n) {
    return static_cast<double>(share.all) >= setting.judged * static_cast<double>(n);
  };
  if (!is_judged(forth, of_before.size()) || !is_judged(back, of_after.size())) return 0;
  // A large part of one that lies on a small part of the other is no match: the worse direction counts.
  return std::min(forth.share(), back.share());
}

double size_of(const Transform& motion, const MatchSurface& before) {
  return norm(motion.point(before.centroid()) - before.centroid()) +
         norm(rotation_vector(motion)) * norm(before.box().max - before.box().min) / 2;
}

// What of before lies on flat parts of after, in its order.
std::vector<PlanePair> flat_pairs(const MatchSurface& before, const MatchSurface& after,
                                  const Transform& motion, double tolerance_m, Task& task) {
  const size_t n = before.points().size();
  std::vector<std::vector<PlanePair>> parts((n + kPairGrain - 1) / kPairGrain);
  parallel_for(task, n, kPairGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      PlanePair pair{before.points()[i], {}, {}};
      if (lies_on(after, motion.point(pair.from), tolerance_m, pair, true))
        parts[begin / kPairGrain].push_back(pair);
    }
  });
  std::vector<PlanePair> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

// Step 4: pairs and adjustment in turns, with all points.
void adjust_motion(const MatchSurface& before, const MatchSurface& after,
                   const MatchSetting& setting, Task& task, RigidMatch& match) {
  MotionModel model(match.motion, before.centroid());
  Adjusted<6> adjusted;
  std::vector<PlanePair> pairs;
  for (int k = 0; k < kRefinements; ++k) {
    pairs = flat_pairs(before, after, model.motion(), setting.tolerance_m, task);
    if (pairs.size() < kLeastPairs) return;
    MotionModel next = model;
    // Without a reach: the pairs are within it, and a sharp end would keep the steps from getting small.
    if (!adjust<MotionModel>(pairs, {}, task, next, adjusted)) return;
    model = next;
  }
  match.motion = model.motion();
  match.rms_m = adjusted.sigma;
  match.covariance = adjusted.covariance;
  // The planes are measured as well, by the points after: their share of the variance is that of one point a plane.
  const double planes = 1 + static_cast<double>(pairs.size()) /
                                static_cast<double>(std::max<size_t>(after.size(), 1));
  for (double& c : match.covariance) c *= planes;
  match.found = true;
}

}  // namespace

LaidOn laid_on(const std::vector<Vec3>& points, const Transform& motion,
               const MatchSurface& surface, const SeenTest& seen, double tolerance_m, Task& task) {
  return parallel_reduce(task, points.size(), 512, LaidOn{}, [&](size_t begin, size_t end) {
    LaidOn part;
    for (size_t i = begin; i < end; ++i) {
      const Vec3 moved = motion.point(points[i]);
      PlanePair pair{points[i], {}, {}};
      const bool on = lies_on(surface, moved, tolerance_m, pair);
      if (!on && seen && !seen(moved)) continue;
      ++part.all;
      part.on += on ? 1 : 0;
    }
    return part;
  });
}

RigidMatch match_rigidly(const MatchSurface& before, const MatchSurface& after,
                         const MatchSetting& setting, Task& task) {
  RigidMatch best;
  if (before.size() < kLeastPairs || after.size() < kLeastPairs) return best;
  const std::vector<Vec3> sample = before.sample(kSample), other = after.sample(kSample);
  double least = 0;
  std::vector<Transform> motions = match_starts(before, after, setting);
  parallel_for(task, motions.size(), 1, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k)
      motions[k] = iterated(sample, before, after, motions[k], setting.tolerance_m, task);
  });
  for (const Transform& motion : motions) {
    const double explained = explained_by(motion, sample, other, before, after, setting, task);
    const double size = size_of(motion, before);
    const bool is_better = explained > best.explained + kEqual ||
                           (explained > best.explained - kEqual && size < least);
    if (!is_better) continue;
    best.motion = motion;
    best.explained = explained;
    least = size;
  }
  adjust_motion(before, after, setting, task, best);
  if (!best.found) return best;
  best.explained =
      explained_by(best.motion, before.points(), after.points(), before, after, setting, task);
  best.rotation = rotation_vector(best.motion);
  best.displacement = best.motion.point(before.centroid()) - before.centroid();
  return best;
}

}  // namespace jalon
