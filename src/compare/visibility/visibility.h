// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/visibility/depth_map.h"

namespace jalon {

/// In the order of preference of algorithm 3: the best label of all viewpoints counts. The numbers of CompareStatus.
enum class Visibility : uint8_t { kVisible = 0, kHidden = 1, kOutOfRange = 2, kOutOfField = 3 };

/// Whether the stations of a reference cloud could have seen a point (Girardeau-Montaut 2006, 2.3.3, algorithm 3 with
/// the margin of its text). Immutable; any number of threads may ask.
class VisibilityTest {
 public:
  /// A map for each station; every point must belong to one with a pose, else kInvalidArgument. O(n + cells).
  VisibilityTest(const Cloud& reference, const DepthSettings& settings, Task& task);

  /// What hides a point: an index of the reference, kNoPoint where no single one does.
  Visibility label(const Vec3& p, uint32_t* occluder = nullptr) const;
  /// Distance between the reference's points where a visible point is seen (m, see DepthMap::spacing_m), by the station
  /// with the least; NaN where none sees it or the cell is empty.
  double spacing_m(const Vec3& p) const;
  /// Labels of up to SightingBlock::kPoints points, 3 coordinates each.
  void label(std::span<const double> xyz, std::span<uint8_t> out) const;
  std::span<const DepthMap> maps() const { return maps_; }

 private:
  Visibility from_map(const DepthMap& map, const Sighting& s, uint32_t* occluder) const;
  DepthSettings settings_;
  size_t maps_each_ = 1;  ///< optical centres of a station
  std::vector<DepthMap> maps_;
};

/// Label of every point of a cloud. O(n), parallel.
std::vector<uint8_t> visibility_labels(const VisibilityTest& test, const Cloud& cloud, Task& task);

/// The cloud with the field "visibility" (uint8).
Cloud with_visibility(const Cloud& reference, const Cloud& cloud, const DepthSettings& settings,
                      Task& task);

}  // namespace jalon
