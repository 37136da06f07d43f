// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/propagation.h"

#include <algorithm>
#include <cmath>

#include "fieldtools/fast_marching.h"

namespace jalon {

namespace {

constexpr double kPropagationInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostExponent =
    100;  // e^100: twice what alpha = 50 reaches, far from the ends of a double

}  // namespace

Propagation::Propagation(const SurfaceCells& cells, std::span<const double> gradient,
                         const PropagationSettings& settings)
    : cells_(cells),
      gradient_(gradient),
      settings_(settings),
      time_(cells.size(), kPropagationInfinity),
      taken_(cells.size()),
      accepted_(cells.size()) {}

/// 1 / F (3.11).
double Propagation::slowness(uint32_t from, uint32_t to) const {
  const double exponent = settings_.alpha * (gradient_[from] - gradient_[to]);
  return std::exp(std::clamp(exponent, -kMostExponent, kMostExponent));
}

/// The time of a cell from its accepted neighbours: across faces by the local equation with one slowness an axis, over
/// edges and corners step by step, so that a front follows surfaces that are askew to the grid.
double Propagation::local_time(uint32_t cell) const {
  AxisStep axes[3];
  bool known[3] = {false, false, false};
  double best = kPropagationInfinity;
  for (const uint32_t q : cells_.neighbours(cell)) {
    if (!accepted_[q]) continue;
    const double slow = slowness(q, cell);
    if (!whole_front() && slow > settings_.jump) continue;
    int apart = 0;
    size_t axis = 0;
    for (size_t c = 0; c < 3; ++c)
      if (cells_.numbers[q][c] != cells_.numbers[cell][c]) {
        ++apart;
        axis = c;
      }
    const double cost = std::sqrt(static_cast<double>(apart)) * cells_.cell_m * slow;
    best = std::min(best, time_[q] + cost);
    if (apart == 1 && (!known[axis] || time_[q] < axes[axis].time)) {
      axes[axis] = {time_[q], cost};
      known[axis] = true;
    }
  }
  AxisStep used[3];
  size_t n = 0;
  for (size_t c = 0; c < 3; ++c)
    if (known[c]) used[n++] = axes[c];
  return n > 0 ? std::min(best, arrival_time({used, n})) : best;
}

FrontRegion Propagation::spread(uint32_t seed_cell, Task& task) {
  constexpr size_t kBetweenLooks = 1024;
  FrontRegion region;
  region.seed_cell = seed_cell;
  region.next_time_m = kPropagationInfinity;
  FrontQueue queue;
  std::vector<uint32_t> touched{seed_cell};
  time_[seed_cell] = 0;
  queue.push(0, seed_cell);
  double last = 0;
  while (!queue.empty()) {
    const FrontQueue::Entry next = queue.pop();
    if (accepted_[next.node] || next.time > time_[next.node]) continue;
    if (whole_front() && next.time - last > settings_.jump * cells_.cell_m) {
      region.next_time_m = next.time;
      break;
    }
    last = std::max(last, next.time);
    accepted_[next.node] = 1;
    region.arrivals.push_back({next.node, last});
    for (const uint32_t p : cells_.neighbours(next.node)) {
      if (accepted_[p] || taken_[p]) continue;
      const double time = local_time(p);
      if (!(time < time_[p])) continue;
      if (time_[p] == kPropagationInfinity) touched.push_back(p);
      time_[p] = time;
      queue.push(time, p);
    }
    if (region.arrivals.size() % kBetweenLooks == 0)
      task.checkpoint(static_cast<double>(region.arrivals.size()) /
                      static_cast<double>(cells_.size()));
  }
  for (const uint32_t cell : touched) time_[cell] = kPropagationInfinity;
  for (const Arrival& a : region.arrivals) {
    accepted_[a.cell] = 0;
    taken_[a.cell] = 1;
  }
  return region;
}

}  // namespace jalon
