// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/field.h"
#include "geometry/vec.h"

namespace jalon {

/// A row of a column of three components.
inline Vec3 vector_at(const Column& column, size_t row) {
  return {column.number(row, 0), column.number(row, 1), column.number(row, 2)};
}

}  // namespace jalon
