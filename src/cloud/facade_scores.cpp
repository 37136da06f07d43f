// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/facade_scores.h"

#include <array>
#include <cmath>

#include "cloud/neighbourhoods.h"

namespace jalon {

namespace {

// From the fewest that make a shape to where a wall of houses ends, each 1.4 times the one before.
constexpr std::array<uint32_t, 7> kScales{10, 14, 20, 28, 40, 56, 80};

struct ScoreAtScale {
  double entropy = 0, score = 0;
  Vec3 normal;
};

// Dimensionality from the standard deviations s1 >= s2 >= s3 along the principal axes.
ScoreAtScale score_of(const PrincipalFrame& frame) {
  const auto& e = frame.eigenvalues;
  const double s1 = std::sqrt(e[2]), s2 = std::sqrt(e[1]), s3 = std::sqrt(std::max(0.0, e[0]));
  const std::array<double, 3> shares{(s1 - s2) / s1, (s2 - s3) / s1, s3 / s1};
  ScoreAtScale made;
  for (const double a : shares)
    if (a > 0) made.entropy -= a * std::log(a);
  made.score = shares[1] * (1 - std::fabs(frame.n.z));
  made.normal = frame.n;
  return made;
}

FacadeScore facade_score(const Octree& tree, const Neighbourhood& around) {
  Moments moments;
  moments.reference = tree.local(around.point);
  ScoreAtScale best{2, 0, {}};  // above the greatest entropy, log 3
  size_t taken = 0;
  for (const uint32_t k : kScales) {
    if (k > around.neighbours.size()) break;
    while (taken < k) moments.add(tree.local(around.neighbours[taken++]));
    PrincipalFrame frame;
    if (!principal_frame(moments, frame)) continue;
    const ScoreAtScale at = score_of(frame);
    if (at.entropy < best.entropy) best = at;
  }
  const double level = std::hypot(best.normal.x, best.normal.y);
  if (!(level > 0)) return {};
  return {static_cast<float>(best.score), {best.normal.x / level, best.normal.y / level}};
}

}  // namespace

std::vector<FacadeScore> facade_scores(const Cloud& cloud, Task& task) {
  struct Nothing {};
  const std::shared_ptr<const Octree> tree = cloud.octree(task);
  const auto order = tree->order();
  std::vector<FacadeScore> scores(cloud.size());
  for_each_neighbourhood<Nothing>(*tree, kScales.back(), 0, task,
                                  [&](const Neighbourhood& around, Nothing&) {
                                    scores[order[around.point]] = facade_score(*tree, around);
                                  });
  return scores;
}

}  // namespace jalon
