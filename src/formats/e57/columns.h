// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/codecs/codecs.h"
#include "formats/settings.h"

namespace jalon::e57 {

/// A column of the records behind the coordinates, from a field of the cloud.
struct OutColumn {
  JcColumn column{};
  const Column* field = nullptr;
  uint32_t component = 0;
  double shift = 0;          ///< added to the field's value
  bool is_validity = false;  ///< 1 where the field's value is no number, else 0
  bool is_normal = false;    ///< one part of a direction, told in the scanner's frame
};

/// How the points of a cloud are told: the same columns for all its scans.
struct Columns {
  std::vector<OutColumn> fields;
  std::deque<std::string> names;  ///< that the columns look at
};

/// Intensity, colours, the scan's grid, returns, time and normals as the standard or its extension
/// calls them; other fields in an extension of our own. What does not fit is logged.
Columns columns_of(const Cloud& cloud, Task& task);

}  // namespace jalon::e57
