// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/landslide/ground_errors.h"

#include <algorithm>
#include <cmath>

#include "base/distributions.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "compare/landslide/cell_map.h"

namespace jalon {

namespace {

constexpr size_t kSmoothingGrain = 1 << 13;
constexpr double kCalmShare = 0.25;    // while it is not known which cells moved: these did not
constexpr uint32_t kBlockSide = 8;     // cells of a block, whose mean tells what they share
constexpr size_t kFewestInBlock = 16;  // a quarter of it
constexpr size_t kFewestBlocks = 8;

double quantile_of(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// The factor that brings the quantile of absolute deviates to that of the normal law.
double scale_of(std::vector<double> deviates, double share) {
  if (deviates.empty()) return 1;
  const double normal = normal_quantile(0.5 + share / 2);
  return std::max(1.0, quantile_of(deviates, share) / normal);
}

// The same of squares: of chi-square with one degree of freedom.
double normal_square(double share) {
  const double deviate = normal_quantile(0.5 + share / 2);
  return deviate * deviate;
}

/// Cells at rest that lie together, by their mean, weighted by their variances.
struct GroundBlock {
  size_t cells = 0;
  double sum = 0, weight = 0;
  double mean() const { return sum / weight; }
  double variance() const { return 1 / weight; }
};

// By the cells of all of them.
struct GroundBlocks {
  std::vector<GroundBlock> blocks;
  std::vector<uint32_t> block_of;  ///< a cell's
  GroundBlock all;
};

bool is_at_rest(const GroundChange& change, std::span<const uint8_t> moved, size_t cell) {
  return change.is_measured(cell) && (moved.empty() || moved[cell] == 0);
}

GroundBlocks blocks_of(const VolumeGrid& grid, const GroundChange& change,
                       std::span<const uint8_t> moved) {
  const size_t across = grid.columns / kBlockSide + 1;
  GroundBlocks out;
  out.blocks.resize(across * (grid.rows / kBlockSide + 1));
  out.block_of.resize(change.difference.size());
  for (size_t cell = 0; cell < change.difference.size(); ++cell) {
    const size_t column = cell % grid.columns / kBlockSide, row = cell / grid.columns / kBlockSide;
    out.block_of[cell] = static_cast<uint32_t>(row * across + column);
    if (!is_at_rest(change, moved, cell)) continue;
    const double weight = 1 / (change.sigma[cell] * change.sigma[cell]);
    for (GroundBlock* block : {&out.blocks[out.block_of[cell]], &out.all}) {
      ++block->cells;
      block->sum += weight * change.difference[cell];
      block->weight += weight;
    }
  }
  return out;
}

// The squares of the blocks' means, less what the scatter of their cells explains: of a quantile, so that a block that
// crept does not tell.
double systematic_of(const GroundBlocks& blocks, double scale, double share) {
  std::vector<double> squares, variances;
  for (const GroundBlock& block : blocks.blocks) {
    if (block.cells < kFewestInBlock) continue;
    squares.push_back(block.mean() * block.mean());
    variances.push_back(scale * scale * block.variance());
  }
  if (squares.size() < kFewestBlocks)
    return blocks.all.cells < kFewestInBlock ? 0 : std::abs(blocks.all.mean());
  const double excess =
      quantile_of(squares, share) / normal_square(share) - quantile_of(variances, share);
  return std::sqrt(std::max(0.0, excess));
}

}  // namespace

SmoothedChange smoothed(const VolumeGrid& grid, const GroundChange& change, Task& task) {
  const size_t n = change.difference.size();
  SmoothedChange out{std::vector<double>(n, kNaN), std::vector<double>(n, kNaN)};
  parallel_for(task, n, kSmoothingGrain, [&](size_t begin, size_t end) {
    for (size_t cell = begin; cell < end; ++cell) {
      if (!change.is_measured(cell)) continue;
      double sum = 0, weight = 0;
      const auto add = [&](size_t at) {
        if (!change.is_measured(at)) return;
        const double own = 1 / (change.sigma[at] * change.sigma[at]);
        sum += own * change.difference[at];
        weight += own;
      };
      add(cell);
      for_each_around(grid, cell, add);
      out.mean_m[cell] = sum / weight;
      out.sigma_m[cell] = 1 / std::sqrt(weight);
    }
  });
  return out;
}

GroundErrors ground_errors(const VolumeGrid& grid, const GroundChange& change,
                           const SmoothedChange& smooth, std::span<const uint8_t> moved) {
  const GroundBlocks blocks = blocks_of(grid, change, moved);
  std::vector<double> own, around;  // about what their blocks share
  for (size_t cell = 0; cell < change.difference.size(); ++cell) {
    const GroundBlock& block = blocks.blocks[blocks.block_of[cell]];
    if (!is_at_rest(change, moved, cell) || block.cells < kFewestInBlock) continue;
    own.push_back(std::abs(change.difference[cell] - block.mean()) / change.sigma[cell]);
    around.push_back(std::abs(smooth.mean_m[cell] - block.mean()) / smooth.sigma_m[cell]);
  }
  const double share = moved.empty() ? kCalmShare : 0.5;
  GroundErrors out;
  out.scale = scale_of(std::move(own), share);
  out.smoothed_scale = scale_of(std::move(around), share);
  out.systematic_m = systematic_of(blocks, out.scale, share);
  return out;
}

}  // namespace jalon
