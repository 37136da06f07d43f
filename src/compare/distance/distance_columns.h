// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "base/field.h"
#include "geometry/vec.h"

namespace jalon {

/// The columns of method "distance", one row a compared point, in the caller's order.
struct DistanceColumns {
  DistanceColumns(size_t points, bool with_differences);

  std::shared_ptr<Column> distance, nearest, status;
  std::shared_ptr<Column> difference[3];  ///< null when not asked for
  double* distances;
  uint32_t* nearests;
  uint8_t* statuses;
  double* differences[3] = {nullptr, nullptr, nullptr};

  void set_difference(size_t i, const Vec3& from_foot) const {
    if (differences[0] == nullptr) return;
    for (int axis = 0; axis < 3; ++axis) differences[axis][i] = from_foot[axis];
  }
  void attach(FieldTable& table) const;
};

}  // namespace jalon
