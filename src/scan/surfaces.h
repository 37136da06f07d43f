// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/params.h"
#include "base/task.h"
#include "model/model.h"
#include "scan/truth.h"

namespace jalon {

/// What a beam meets, triangle by triangle: face, true plane, and how often glass returns it. The model must be valid
/// and outlive it.
class Surfaces {
 public:
  /// Reads truth_min_area_m2, glass_return_min, glass_return_max and seed.
  Surfaces(const Model& model, const ParamSet& params, Task& task);

  uint32_t face(uint32_t triangle) const { return model_.triangle_faces[triangle]; }
  uint32_t segment(uint32_t triangle) const { return truth_.triangle_segments[triangle]; }
  /// Unit vector; zero for a triangle without area.
  Vec3 normal(uint32_t triangle) const;
  /// Of two opposite vectors, as seen from both sides.
  double cosine(uint32_t triangle, const Vec3& direction) const;
  bool has_glass() const { return !glass_.empty(); }
  /// Share of the pulses that this triangle returns: 1 but for glass.
  double returned(uint32_t triangle) const { return glass_.empty() ? 1 : glass_[triangle]; }

 private:
  const Model& model_;
  Truth truth_;
  std::vector<double> glass_;  ///< empty when everything returns
};

/// The rows that Surfaces reads, but the seed.
constexpr ParamRow kTruthRow =
    number_row("truth_min_area_m2", 0.05, 0, 1e9, "m2", "",
               "connected coplanar faces from this area on are a true plane: the numbers of the field segment");
constexpr ParamRow kGlassMinRow =
    number_row("glass_return_min", 1, 0, 1, "1", "",
               "least share of the pulses that a pane of glass returns; each has its own, the others pass through");
constexpr ParamRow kGlassMaxRow = number_row("glass_return_max", 1, 0, 1, "1", "", "largest share, at least the least");

}  // namespace jalon
