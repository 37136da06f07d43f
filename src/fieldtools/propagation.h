// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "cloud/cloud.h"
#include "fieldtools/fast_marching_cells.h"

namespace jalon {

/// How a front spreads over cells whose deviations and gradients are known (Girardeau-Montaut 2006, 3.3.2).
struct PropagationSettings {
  double cell_m = 0;  ///< 0: from the spacing
  double alpha = 50;  ///< F = exp(alpha (g_j - g_i)) from cell i to cell j (3.11)
  /// Stop at the first jump, or bar only the step that would take so long.
  enum class Scope { kFront, kStep } scope = Scope::kFront;
  double jump = 100;        ///< of arrival time, in steps of one cell at speed 1
  double minimum_seed = 0;  ///< 0: the cut of two means of the deviations
  uint64_t min_points = 10;
  std::string name = "region";
  std::string arrival_name{};  ///< empty: none
};

/// One cell taken by a front.
struct Arrival {
  uint32_t cell;
  double time_m;  ///< at speed 1 metre for metre
};

/// One sub-cloud.
struct FrontRegion {
  uint32_t seed_cell = 0;
  std::vector<Arrival> arrivals;  ///< in order; the seed first
  double next_time_m = 0;  ///< of the cell that the front stopped at; infinite when none was left
};

/// Fronts over the cells, one after the other, each taking cells that are left.
class Propagation {
 public:
  /// gradient: one a cell. Both must outlive this.
  Propagation(const SurfaceCells& cells, std::span<const double> gradient,
              const PropagationSettings& settings);
  bool is_taken(uint32_t cell) const { return taken_[cell] != 0; }
  FrontRegion spread(uint32_t seed_cell, Task& task);

 private:
  bool whole_front() const { return settings_.scope == PropagationSettings::Scope::kFront; }
  double slowness(uint32_t from, uint32_t to) const;
  double local_time(uint32_t cell) const;

  const SurfaceCells& cells_;
  std::span<const double> gradient_;
  PropagationSettings settings_;
  std::vector<double> time_;
  std::vector<uint8_t> taken_, accepted_;
};

std::span<const ParamRow> propagation_rows();

struct PropagationResult {
  std::vector<uint32_t> labels;   ///< one a point; 1 = most points, 0 = none
  std::vector<double> arrival_m;  ///< one a point; NaN = none
  FieldTable regions;             ///< one row a label
  double minimum_seed = 0;
};
/// Segmentation by gradient-constrained propagation; see jalon/field_tools.h.
PropagationResult segment_by_propagation(const Cloud& cloud, std::span<const double> deviations,
                                         std::span<const double> gradients,
                                         const PropagationSettings& settings, Task& task);

}  // namespace jalon
