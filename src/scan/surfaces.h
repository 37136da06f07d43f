// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/setting_rows.h"
#include "base/task.h"
#include "model/model.h"
#include "scan/surface_settings.h"
#include "scan/truth.h"

namespace jalon {

/// What a beam meets, triangle by triangle: face, true plane, how often glass returns it, and what swallows it: faces
/// of parts of class "dark". The model must be valid
/// and outlive it.
class Surfaces {
 public:
  /// seed: of each pane's share.
  Surfaces(const Model& model, const ScannedSurfaceSettings& settings, uint64_t seed, Task& task);

  uint32_t face(uint32_t triangle) const { return model_.triangle_faces[triangle]; }
  uint32_t segment(uint32_t triangle) const { return truth_.triangle_segments[triangle]; }
  /// Unit vector; zero for a triangle without area.
  Vec3 normal(uint32_t triangle) const;
  /// Of two opposite vectors, as seen from both sides.
  double cosine(uint32_t triangle, const Vec3& direction) const;
  /// Share of the pulses that this triangle returns: 1 but for glass and what is dark.
  double returned(uint32_t triangle) const { return returned_.empty() ? 1 : returned_[triangle]; }
  /// Of the pulses that it does not return: whether they go on, or are lost.
  bool lets_through(uint32_t triangle) const { return dark_.empty() || dark_[triangle] == 0; }

 private:
  const Model& model_;
  Truth truth_;
  std::vector<double> returned_;  ///< empty when everything returns
  std::vector<char> dark_;        ///< of the triangles; empty when none is
};

/// The rows of ScannedSurfaceSettings, in the two places where the scanners' tables have them.
inline constexpr auto kGlassRows = setting_rows(
    number_row<&ScannedSurfaceSettings::glass_return_min>(
        "glass_return_min", 0, 1, "1", "",
        "least share of the pulses that a pane of glass returns; each has its own, the others pass "
        "through"),
    number_row<&ScannedSurfaceSettings::glass_return_max>("glass_return_max", 0, 1, "1", "",
                                                          "largest share, at least the least"));
inline constexpr auto kTruthRows =
    setting_rows(number_row<&ScannedSurfaceSettings::truth_min_area_m2>(
        "truth_min_area_m2", 0, 1e9, "m2", "",
        "connected coplanar faces from this area on are a true plane: the numbers of the field "
        "segment"));

}  // namespace jalon
