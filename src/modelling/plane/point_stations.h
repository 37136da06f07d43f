// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "cloud/cloud.h"

namespace jalon {

/// The station that each point was seen from, by ranges of points. Ask with indices that do not fall.
class PointStations {
 public:
  explicit PointStations(const Cloud& cloud) : cloud_(cloud) {}

  /// nullptr: the point is of no station, or of one without a pose. O(1) amortised.
  const Station* of(size_t i) {
    const auto& stations = cloud_.stations;
    while (next_ < stations.size() && i >= stations[next_].first + stations[next_].count) ++next_;
    const bool is_known =
        next_ < stations.size() && i >= stations[next_].first && stations[next_].has_pose;
    return is_known ? &stations[next_] : nullptr;
  }

 private:
  const Cloud& cloud_;
  size_t next_ = 0;
};

}  // namespace jalon
