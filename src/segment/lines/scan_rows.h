// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "cloud/cloud.h"

namespace jalon {

/// A point where the scanner put it: its row, and its place along the row.
struct ScanPlace {
  uint64_t row = 0;  ///< station first, then the row of that station
  double along = 0;
  uint32_t point = 0;  ///< index in the cloud
};

/// Points row by row, each row in its order. From the fields "row" and "column", which grids of scanners have; else by
/// the angles about stations with a pose: rows are then vertical profiles as wide as the mean step of the angles
/// (Jiang & Bunke 1994 take constant horizontal angles). Error(kUnsupported) where neither is there: points that no
/// station saw are in no row.
std::vector<ScanPlace> scan_places(const Cloud& cloud, Task& task);

}  // namespace jalon
