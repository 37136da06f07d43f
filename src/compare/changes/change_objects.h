// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "compare/changes/regions.h"
#include "compare/changes/support.h"
#include "compare/comparison.h"

namespace jalon {

/// One direction of a two-way comparison: the compared cloud with what is known of its points.
struct Epoch {
  const Comparison* comparison = nullptr;
  ChangeRegions regions;
  Vec3 origin;  ///< of the local coordinates of both epochs

  const Cloud& cloud() const { return *comparison->cloud; }
  Vec3 local(size_t i) const { return cloud().point(i) - origin; }
  bool is_compared(size_t i) const {
    return statuses()[i] == static_cast<uint8_t>(CompareStatus::kCompared);
  }
  std::span<const uint8_t> statuses() const {
    return comparison->points.require("status").values<uint8_t>();
  }
  /// Nearest point of the other epoch; kNoPoint where there is none.
  uint32_t nearest(size_t i) const {
    return comparison->points.require("nearest").values<uint32_t>()[i];
  }
};

/// Area of the surface of these regions (labels).
double changed_area(const Epoch& epoch, const std::vector<uint32_t>& labels);
/// Between that surface and the other epoch.
double changed_volume(const Epoch& epoch, const std::vector<uint32_t>& labels);

/// An object of which something changed, whole: its changed points and the unchanged ones that hang together with them,
/// without what it stands on.
struct ChangedObject {
  std::vector<uint32_t> before, after;                  ///< points of either epoch, ascending
  std::vector<uint32_t> regions_before, regions_after;  ///< labels
  std::vector<Support> supports;
};

/// The regions of an object as objects of their own, each with the unchanged points beside it: for what did not move as
/// a whole.
std::vector<ChangedObject> single_regions(const Epoch& before, const Epoch& after,
                                          const ChangedObject& object, double cell_m);

/// What hangs together with these changed points of both epochs, whole, as in whole_objects; they alone where it ends
/// nowhere within reach. Without the labels of regions.
ChangedObject whole_object(const Epoch& before, const Epoch& after,
                           const std::vector<uint32_t>& changed_before,
                           const std::vector<uint32_t>& changed_after, double tolerance_m,
                           Task& task);

/// Whole objects from changed regions (Girardeau-Montaut 2006, 3.5.4: "segmentation of the whole object"): 1. what
/// stands unchanged and goes on beyond a region is taken away; 2. what hangs together with the region's points is the
/// object; 3. where its unchanged points lie in the other epoch, the object of that epoch begins; both until nothing is
/// added. Objects that end nowhere within reach (ground without a plane) stay the regions they were. Largest first.
std::vector<ChangedObject> whole_objects(const Epoch& before, const Epoch& after,
                                         double tolerance_m, Task& task);

}  // namespace jalon
