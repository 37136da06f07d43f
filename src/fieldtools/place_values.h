// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fieldtools/field_values.h"

namespace jalon {

/// The values of points that share a place of the octree's grid, sorted, with their sums: how many lie near another
/// value, and what they add up to, is known without looking at each. For trees that have crowds.
class PlaceValues {
 public:
  /// The points must outlive it.
  PlaceValues(const ValuedPoints& valued, Task& task);

  struct Part {
    size_t count = 0;
    double sum = 0;  ///< of value - from
  };
  /// The values at the positions of a group with from - most <= value <= from + most, as differences from it.
  Part within(const Octree::PlaceGroup& group, double from, double most) const;

 private:
  struct Place {
    uint32_t first, last;
    size_t at;  // of its first value in sorted_
  };
  void add_place(size_t first, size_t last, Task& task);
  const Place* whole_place(const Octree::PlaceGroup& group) const;

  std::span<const double> values_;
  std::vector<Place> places_;   // of more than a few points
  std::vector<double> sorted_;  // their values, place by place
  std::vector<double> sums_;    // of the values of the place before each
};

}  // namespace jalon
