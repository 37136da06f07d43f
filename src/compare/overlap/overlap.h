// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "cloud/cloud.h"

namespace jalon {

/// Why two clouds of one place lie apart; the numbers of jalon/comparer.h.
enum class ApartCause : uint8_t {
  kUnknown = 0,
  kAxes = 1,     ///< axes swapped or turned round
  kUnit = 2,     ///< another unit of length
  kOrigin = 3,   ///< the same extent elsewhere: another origin or CRS
  kDegrees = 4,  ///< one is in degrees of longitude and latitude
};

/// How much of two clouds lies at the same place, by cells of a hundredth of the smaller one's diagonal or as large as
/// hold some points each.
struct CloudsOverlap {
  double reference_share = 0,
         compared_share = 0;  ///< of its cells, at or beside cells of the other
  double gap_m = 0;           ///< between their boxes; 0 where those meet
  bool is_apart = false;      ///< they hardly share a place
  /// Of that, or of their sharing less than other axes or another unit would make them.
  ApartCause cause = ApartCause::kUnknown;
  /// kAxes: which axis of the compared cloud, 1 ... 3, negative where turned round, is x, y, z of the reference.
  std::array<int8_t, 3> axes{1, 2, 3};
  double factor = 1;  ///< kUnit: by which the compared cloud's coordinates are to be multiplied
  Vec3 shift;         ///< kOrigin: of the compared cloud onto the reference, roughly
};

/// O(n) for the boxes, the rest by samples.
CloudsOverlap clouds_overlap(const Cloud& reference, const Cloud& compared, Task& task);
/// One row.
FieldTable overlap_table(const CloudsOverlap& overlap);

}  // namespace jalon
