// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/chamfer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "fieldtools/fast_marching.h"

namespace jalon {

namespace {

constexpr uint16_t kFar = 0xffff;
constexpr size_t kChamferCellsPerChunk = 1 << 16;

/// Half of the 26 neighbours with their weights: those that a raster pass has seen before.
struct Mask {
  int dx, dy, dz;
  uint16_t weight;
};
std::vector<Mask> half_mask() {
  std::vector<Mask> out;
  for (int dz = -1; dz <= 0; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (dz == 0 && (dy > 0 || (dy == 0 && dx >= 0))) continue;
        out.push_back(
            {dx, dy, dz, static_cast<uint16_t>(2 + std::abs(dx) + std::abs(dy) + std::abs(dz))});
      }
  return out;
}

/// One raster pass; direction +1 forward, -1 backward.
void raster_pass(const DistanceGrid& grid, int direction, std::vector<uint16_t>& thirds,
                 Task& task) {
  const std::vector<Mask> mask = half_mask();
  const auto nx = static_cast<int>(grid.size[0]), ny = static_cast<int>(grid.size[1]),
             nz = static_cast<int>(grid.size[2]);
  for (int k = 0; k < nz; ++k) {
    task.checkpoint(static_cast<double>(k) / nz);
    const int z = direction > 0 ? k : nz - 1 - k;
    for (int j = 0; j < ny; ++j) {
      const int y = direction > 0 ? j : ny - 1 - j;
      for (int i = 0; i < nx; ++i) {
        const int x = direction > 0 ? i : nx - 1 - i;
        uint16_t& own = thirds[grid.index(static_cast<uint32_t>(x), static_cast<uint32_t>(y),
                                          static_cast<uint32_t>(z))];
        for (const Mask& m : mask) {
          const int a = x + direction * m.dx, b = y + direction * m.dy, c = z + direction * m.dz;
          if (a < 0 || b < 0 || c < 0 || a >= nx || b >= ny || c >= nz) continue;
          const uint16_t other = thirds[grid.index(
              static_cast<uint32_t>(a), static_cast<uint32_t>(b), static_cast<uint32_t>(c))];
          if (other < kFar - m.weight)
            own = std::min<uint16_t>(own, static_cast<uint16_t>(other + m.weight));
        }
      }
    }
  }
}

/// The local equation at a cell from its accepted face neighbours.
class GridFront {
 public:
  GridFront(const DistanceGrid& grid, std::vector<float>& time)
      : grid_(grid),
        time_(time),
        accepted_(time.size()),
        steps_{1, grid.size[0], uint64_t{grid.size[0]} * grid.size[1]} {}

  void start(uint64_t cell, float time) {
    time_[cell] = std::min(time_[cell], time);
    queue_.push(double{time_[cell]}, static_cast<uint32_t>(cell));
  }

  void run(Task& task) {
    constexpr size_t kBetweenLooks = 4096;
    size_t done = 0;
    while (!queue_.empty()) {
      const FrontQueue::Entry next = queue_.pop();
      if (accepted_[next.node] || next.time > double{time_[next.node]}) continue;
      accepted_[next.node] = 1;
      for (size_t axis = 0; axis < 3; ++axis) {
        const uint32_t at = number(next.node, axis);
        if (at > 0) update(next.node - steps_[axis]);
        if (at + 1 < grid_.size[axis]) update(next.node + steps_[axis]);
      }
      if (++done % kBetweenLooks == 0)
        task.checkpoint(static_cast<double>(done) / static_cast<double>(time_.size()));
    }
  }

 private:
  uint32_t number(uint64_t cell, size_t axis) const {
    return static_cast<uint32_t>(cell / steps_[axis] % grid_.size[axis]);
  }

  void update(uint64_t cell) {
    if (accepted_[cell]) return;
    AxisStep axes[3];
    size_t n = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
      const uint32_t at = number(cell, axis);
      double earlier = std::numeric_limits<double>::infinity();
      if (at > 0 && accepted_[cell - steps_[axis]]) earlier = double{time_[cell - steps_[axis]]};
      if (at + 1 < grid_.size[axis] && accepted_[cell + steps_[axis]])
        earlier = std::min(earlier, double{time_[cell + steps_[axis]]});
      if (std::isfinite(earlier)) axes[n++] = {earlier, grid_.cell_m};
    }
    const auto time = static_cast<float>(arrival_time({axes, n}));
    if (!(time < time_[cell])) return;
    time_[cell] = time;
    queue_.push(double{time}, static_cast<uint32_t>(cell));
  }

  const DistanceGrid& grid_;
  std::vector<float>& time_;
  std::vector<uint8_t> accepted_;
  std::array<uint64_t, 3> steps_;
  FrontQueue queue_;
};

}  // namespace

std::vector<float> chamfer_distances(const DistanceGrid& grid, std::span<const uint64_t> occupied,
                                     Task& task) {
  std::vector<uint16_t> thirds(grid.cells(), kFar);
  for (const uint64_t cell : occupied) thirds[cell] = 0;
  {
    ProgressSpan span(task, 0, 0.5);
    raster_pass(grid, +1, thirds, task);
  }
  ProgressSpan span(task, 0.5, 1);
  raster_pass(grid, -1, thirds, task);
  std::vector<float> out(thirds.size());
  parallel_for(task, out.size(), kChamferCellsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      out[i] = thirds[i] == kFar ? std::numeric_limits<float>::infinity()
                                 : static_cast<float>(thirds[i] / 3.0 * grid.cell_m);
  });
  return out;
}

std::vector<float> marched_distances(const DistanceGrid& grid, std::span<const uint64_t> occupied,
                                     std::span<const float> starts, Task& task) {
  std::vector<float> out(grid.cells(), std::numeric_limits<float>::infinity());
  GridFront front(grid, out);
  for (size_t i = 0; i < occupied.size(); ++i) front.start(occupied[i], starts[i]);
  front.run(task);
  return out;
}

}  // namespace jalon
