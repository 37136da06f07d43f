// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace jalon {

/// What two sets share, place by place (Egenhofer & Herring 1990): for boundary, interior and exterior of A (rows) and
/// of B (columns) the dimension of their intersection: -1 nothing, 0 points, 1 lines, 2 surfaces, 3 volumes.
struct NineIntersection {
  enum Place : size_t { kBoundary, kInterior, kExterior };

  std::array<int8_t, 9> dimensions{-1, -1, -1, -1, -1, -1, -1, -1, -1};

  int8_t at(Place a, Place b) const { return dimensions[3 * a + b]; }
  bool is_empty(Place a, Place b) const { return at(a, b) < 0; }
  /// Sets the dimension where it is lower.
  void raise(Place a, Place b, int8_t dimension) {
    int8_t& held = dimensions[3 * a + b];
    if (held < dimension) held = dimension;
  }
  /// That of B and A.
  NineIntersection transposed() const {
    const auto& d = dimensions;
    return {{d[0], d[3], d[6], d[1], d[4], d[7], d[2], d[5], d[8]}};
  }
  /// Highest dimension that boundaries and interiors share; -1: the sets lie apart.
  int8_t contact() const;
  bool operator==(const NineIntersection&) const = default;
};

/// The relations of the region calculus (Egenhofer & Herring 1990; Cui, Cohn & Randell 1993); the numbers of
/// jalon/model.h.
enum class RegionRelation : uint8_t {
  kDisjoint = 1,
  kMeet = 2,     ///< boundaries share points, interiors none
  kOverlap = 3,  ///< interiors share points, and each has some of its own
  kCovers = 4,   ///< B lies in A, and their boundaries meet
  kCoveredBy = 5,
  kContains = 6,  ///< B lies in A, away from its boundary
  kInside = 7,
  kEqual = 8
};

/// The relation that a matrix stands for. Beyond the eight matrices of simple regions (those of regions with holes, of
/// several pieces, of surfaces in space) the words are read as they are said above.
RegionRelation relation_of(const NineIntersection& matrix);

/// "disjoint", "meet", "overlap", "covers", "covered_by", "contains", "inside", "equal".
const char* name_of(RegionRelation relation);

}  // namespace jalon
