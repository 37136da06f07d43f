// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/spread.h"

#include <algorithm>
#include <cmath>

#include "geometry/plane.h"
#include "spatial/quantile.h"

namespace jalon {

namespace {

constexpr size_t kPlacesLookedAt =
    1000;  // neighbourhoods looked at: a share of so many is sure to 2 %
// Of dimensions: points of a line have one, those drawn over a surface two, in grids somewhat more. Between them there
// is little: once the neighbours reach the next line they count as spread over both ways.
constexpr double kLineDimension = 1.6;
// Squared distance, of that of the farthest neighbour: the point itself, whose place is rounded, and its doubles.
constexpr double kSamePlace = 1e-8;
constexpr uint32_t kMany = 4;  // times k neighbours, that noise is told by

// The inverse of the dimension that the neighbours of a point spread over, by the ratios of their distances (Levina &
// Bickel 2004, eq. 8; inverses are averaged: MacKay & Ghahramani 2005). Below 0: all in one place.
template <class Squared>
double inverse_dimension(size_t k, Squared squared) {
  double farthest = 0;
  for (size_t i = 0; i < k; ++i) farthest = std::max(farthest, double{squared(i)});
  double sum = 0;
  size_t count = 0;
  for (size_t i = 0; i < k; ++i) {
    const double s = squared(i);
    if (!(s > kSamePlace * farthest) || !(s < farthest)) continue;
    sum += 0.5 * std::log(farthest / s);
    ++count;
  }
  return count == 0 ? -1 : sum / static_cast<double>(count);
}

double mean_of(const std::vector<float>& inverse, std::span<const uint32_t> neighbours) {
  double sum = 0;
  size_t count = 0;
  for (const uint32_t i : neighbours) {
    if (i == kNoPoint || inverse[i] < 0) continue;
    sum += double{inverse[i]};
    ++count;
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

Eigen3 extents_of(const Octree& tree, std::span<const Neighbour> neighbours) {
  Moments moments;
  moments.reference = tree.local(neighbours[0].index);
  for (const Neighbour& n : neighbours) moments.add(tree.local(n.index));
  return symmetric_eigen(moments.covariance());
}

}  // namespace

bool lies_in_line(const Octree& tree, std::span<const Neighbour> neighbours,
                  std::vector<Neighbour>& theirs) {
  const auto k = static_cast<uint32_t>(neighbours.size());
  theirs.resize(k);
  double sum = 0, count = 0;
  for (const Neighbour& n : neighbours) {
    tree.knn_positions(tree.cube().origin + tree.local(n.index), k, theirs);
    const double inverse =
        inverse_dimension(k, [&](size_t i) { return theirs[i].squared_distance; });
    if (inverse < 0) continue;
    sum += inverse, count += 1;
  }
  return sum > count / kLineDimension;
}

PointSpread spread_of(const Octree& tree, uint32_t k, Task& task) {
  const auto of_few = static_cast<uint32_t>(std::min<size_t>(k, tree.size()));
  const auto of_many = static_cast<uint32_t>(std::min<size_t>(size_t{kMany} * k, tree.size()));
  std::vector<Neighbour> found(of_many), theirs;
  std::vector<double> lengths, radii, noises;
  size_t looked_at = 0, in_lines = 0, in_one_place = 0;
  for (size_t position = 0; position < tree.size(); position += tree.size() / kPlacesLookedAt + 1) {
    task.checkpoint(0);
    ++looked_at;
    tree.knn_positions(tree.cube().origin + tree.local(position), of_many, found);
    const auto few = std::span<const Neighbour>(found).first(of_few);
    // All as far, by no more than places are rounded: the point itself is one of them.
    if (few.back().squared_distance <= few.front().squared_distance) {
      ++in_one_place;
      continue;
    }
    in_lines += lies_in_line(tree, few, theirs);
    const Eigen3 near = extents_of(tree, few), wide = extents_of(tree, found);
    lengths.push_back(std::sqrt(std::max(0.0, near.values[2])));
    radii.push_back(std::sqrt(std::max(0.0, near.values[1] + near.values[2])));
    noises.push_back(std::sqrt(std::max(0.0, wide.values[0])));
  }
  PointSpread out;
  out.in_one_place =
      static_cast<double>(in_one_place) / static_cast<double>(std::max<size_t>(1, looked_at));
  if (lengths.empty()) return out;
  out.in_lines = static_cast<double>(in_lines) / static_cast<double>(lengths.size());
  out.length_m = quantile_of(lengths, 0.5);
  out.radius_m = quantile_of(radii, 0.5);
  out.noise_m = quantile_of(noises, 0.25);
  return out;
}

std::vector<bool> points_in_lines(const Octree& tree, uint32_t k, Task& task) {
  const auto used = static_cast<uint32_t>(std::min<size_t>(k, tree.size()));
  std::vector<float> inverse(tree.size());
  std::vector<uint8_t> out(tree.size());
  tree.for_each_knn(used, task, [&](const Octree::Batch& b) {
    for (size_t i = 0; i < b.count; ++i)
      inverse[b.first + i] = static_cast<float>(
          inverse_dimension(b.k, [&](size_t j) { return b.squared[i * b.k + j]; }));
  });
  tree.for_each_knn(used, task, [&](const Octree::Batch& b) {
    for (size_t i = 0; i < b.count; ++i)
      out[b.first + i] = mean_of(inverse, {b.neighbours + i * b.k, b.k}) > 1 / kLineDimension;
  });
  return {out.begin(), out.end()};
}

}  // namespace jalon
