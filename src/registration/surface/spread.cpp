// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/surface/spread.h"

#include <algorithm>
#include <cmath>

#include "geometry/symmetric_eigen.h"

namespace jalon {

namespace {

constexpr size_t kSample = 1000;  // neighbourhoods looked at: a share of so many is sure to 2 %
// Of dimensions: points of a line have one, those drawn over a surface two, in grids somewhat more. Between them there
// is little: once the neighbours reach the next line they count as spread over both ways.
constexpr double kLineDimension = 1.6;
// Squared distance, of that of the farthest neighbour: the point itself, whose place is rounded, and its doubles.
constexpr double kSamePlace = 1e-8;
constexpr uint32_t kMany = 4;  // times k neighbours, that noise is told by

// The inverse of the dimension that the neighbours of a point spread over, by the ratios of their distances (Levina &
// Bickel 2004, eq. 8; inverses are averaged: MacKay & Ghahramani 2005). Below 0: all in one place.
double inverse_dimension(std::span<const float> squared) {
  const double farthest = *std::max_element(squared.begin(), squared.end());
  double sum = 0;
  size_t count = 0;
  for (const float s : squared) {
    if (!(s > kSamePlace * farthest) || !(s < farthest)) continue;
    sum += 0.5 * std::log(farthest / double{s});
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

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto at =
      values.begin() + static_cast<ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Eigen3 extents_of(const Octree& tree, std::span<const Neighbour> neighbours) {
  const Vec3 from = tree.local(neighbours[0].index);
  Vec3 sum;
  Symmetric3 products{};
  for (const Neighbour& n : neighbours) {
    const Vec3 d = tree.local(n.index) - from;
    sum += d;
    const double row[6] = {d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.y, d.y * d.z, d.z * d.z};
    for (size_t c = 0; c < 6; ++c) products[c] += row[c];
  }
  const auto count = static_cast<double>(neighbours.size());
  const Vec3 m = sum / count;
  const double mean[6] = {m.x * m.x, m.x * m.y, m.x * m.z, m.y * m.y, m.y * m.z, m.z * m.z};
  for (size_t c = 0; c < 6; ++c) products[c] = products[c] / count - mean[c];
  return symmetric_eigen(products);
}

}  // namespace

PointSpread spread_of(const Octree& tree, uint32_t k, Task& task) {
  const auto of_few = static_cast<uint32_t>(std::min<size_t>(k, tree.size()));
  const auto of_many = static_cast<uint32_t>(std::min<size_t>(size_t{kMany} * k, tree.size()));
  std::vector<Neighbour> found(of_many), theirs(of_few);
  std::vector<double> lengths, radii, noises;
  size_t looked_at = 0, in_lines = 0, in_one_place = 0;
  std::vector<float> squared(of_few);
  const auto inverse_at = [&](std::span<const Neighbour> neighbours) {
    for (size_t i = 0; i < squared.size(); ++i)
      squared[i] = static_cast<float>(neighbours[i].squared_distance);
    return inverse_dimension(squared);
  };
  for (size_t position = 0; position < tree.size(); position += tree.size() / kSample + 1) {
    task.checkpoint(0);
    ++looked_at;
    tree.knn_positions(tree.cube().origin + tree.local(position), of_many, found);
    const auto few = std::span<const Neighbour>(found).first(of_few);
    if (!(few.back().squared_distance > 0)) {
      ++in_one_place;
      continue;
    }
    double sum = 0, count = 0;
    for (const Neighbour& n : few) {
      tree.knn_positions(tree.cube().origin + tree.local(n.index), of_few, theirs);
      const double inverse = inverse_at(theirs);
      if (inverse < 0) continue;
      sum += inverse, count += 1;
    }
    in_lines += sum > count / kLineDimension;
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
  out.length_m = quantile(lengths, 0.5);
  out.radius_m = quantile(radii, 0.5);
  out.noise_m = quantile(noises, 0.25);
  return out;
}

std::vector<bool> points_in_lines(const Octree& tree, uint32_t k, Task& task) {
  const auto used = static_cast<uint32_t>(std::min<size_t>(k, tree.size()));
  std::vector<float> inverse(tree.size());
  std::vector<uint8_t> out(tree.size());
  tree.for_each_knn(used, task, [&](const Octree::Batch& b) {
    for (size_t i = 0; i < b.count; ++i)
      inverse[b.first + i] = static_cast<float>(inverse_dimension({b.squared + i * b.k, b.k}));
  });
  tree.for_each_knn(used, task, [&](const Octree::Batch& b) {
    for (size_t i = 0; i < b.count; ++i)
      out[b.first + i] = mean_of(inverse, {b.neighbours + i * b.k, b.k}) > 1 / kLineDimension;
  });
  return {out.begin(), out.end()};
}

}  // namespace jalon
