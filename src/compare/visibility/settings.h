// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/params.h"
#include "geometry/vec.h"

namespace jalon {

/// Which of the points of a cell the map keeps (2.3.3 leaves it open; annex E takes the nearest).
enum class CellRule : uint8_t { kNearest, kFarthest, kMean };
/// What a cell without a point says: everything in it is hidden, or nothing is (annex E.1).
/// Automatic: nothing, where the scanner's range is known, for then the sky is known to be empty.
enum class EmptyCell : uint8_t { kAutomatic, kHides, kFree };

/// How depth maps are made and asked. Rule and cell are the best of those tried on the days of
/// scene "earthworks": with (mean, 1.5) 98.5 % at least of the points more than the margin behind
/// the seen surface are found hidden on each of the twelve pairs of days, and 1.0 % at most of
/// those on it are lost; (mean, 1) 82 % and 1.4 %, (mean, 1.75) 98.4 % and 1.4 %, (min, 1.5) 98.5 %
/// and 1.5 %, (max, 1.5) 95.5 % and 0.7 %.
struct DepthSettings {
  double horizontal_step_rad = 0, vertical_step_rad = 0;  ///< 0: from the points
  double cell_factor = 1.5;                               ///< cell over step
  CellRule rule = CellRule::kMean;
  int fill_passes = 2;
  EmptyCell empty = EmptyCell::kAutomatic;
  double margin_m = 0.1, margin_factor = 1.002;
  double max_range_m = 0;                           ///< 0: unknown
  std::vector<double> second_centre_m = {0, 0, 0};  ///< in the scanner's frame; zero: none

  bool empty_is_free() const {
    return empty == EmptyCell::kFree || (empty == EmptyCell::kAutomatic && max_range_m > 0);
  }
  /// Throws kInvalidArgument unless second_centre_m has three numbers.
  void check() const;
  Vec3 second_centre() const {
    return {second_centre_m[0], second_centre_m[1], second_centre_m[2]};
  }
};

/// What becomes of the points that the reference's stations could not see (Girardeau-Montaut
/// 2006, 2.4.4).
struct HiddenSettings {
  enum class Way : uint8_t { kLeave, kVertical, kOccluders };
  Way way = Way::kLeave;
  std::vector<double> direction = {0, 0, 1};  ///< of kVertical, of any length
  double radius_m = 2;     ///< of kVertical: longest edge in plan of its triangles
  double zone_m = 0.5;     ///< of kOccluders: cell of the grid that joins hidden points
  double shape_ratio = 2;  ///< of kOccluders: of one shape up to so many spacings

  /// Throws kInvalidArgument unless the direction has three numbers and a length.
  void check() const;
  Vec3 unit_direction() const { return normalized({direction[0], direction[1], direction[2]}); }
};

/// Parameter table of the operation "visibility", of DepthSettings.
std::span<const ParamRow> visibility_rows();

}  // namespace jalon
