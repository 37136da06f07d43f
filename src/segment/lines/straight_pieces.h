// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane.h"
#include "segment/lines/scan_rows.h"
#include "segment/scan_line_settings.h"
#include "segment/surface/scene.h"

namespace jalon {

/// A straight piece of a row.
struct ScanLine {
  uint64_t row = 0;
  double from = 0, to = 0;       ///< along the row
  uint32_t first = 0, last = 0;  ///< places in the list of scan_places()
  Moments moments;               ///< about the middle of the scene
};

/// Where a chain of points is to be cut so that each piece keeps within the tolerance of its chord: split at the
/// farthest point, again and again (Jiang & Bunke 1994). Places in the chain, first and last included.
std::vector<uint32_t> straight_cuts(std::span<const Vec3> chain, double tolerance_m);

/// The straight pieces of all rows, row by row. positions: of the cloud's points in the scene.
std::vector<ScanLine> straight_pieces(const SegmentScene& scene, std::span<const ScanPlace> places,
                                      std::span<const uint32_t> positions,
                                      const ScanLineSettings& settings, Task& task);

}  // namespace jalon
