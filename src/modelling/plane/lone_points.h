// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cloud/cloud.h"

namespace jalon {

/// Points on no segment that have no other point near: strays, that tell nothing of what beams passed.
class LonePoints {
 public:
  /// labels: of segments, 0 = of none; near_m: within which another one must lie. Some microseconds a lone point.
  LonePoints(const Cloud& cloud, std::span<const uint32_t> labels, double near_m, Task& task);
  bool has(size_t point) const { return (bits_[point / 64] >> point % 64 & 1) != 0; }

 private:
  std::vector<uint64_t> bits_;
};

}  // namespace jalon
