// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/nine_intersection.h"

#include <algorithm>

namespace jalon {

int8_t NineIntersection::contact() const {
  return std::max({at(kBoundary, kBoundary), at(kBoundary, kInterior), at(kInterior, kBoundary),
                   at(kInterior, kInterior)});
}

RegionRelation relation_of(const NineIntersection& matrix) {
  using enum NineIntersection::Place;
  if (matrix.contact() < 0) return RegionRelation::kDisjoint;
  if (matrix.is_empty(kInterior, kInterior)) return RegionRelation::kMeet;
  const bool is_in = matrix.is_empty(kInterior, kExterior),
             holds = matrix.is_empty(kExterior, kInterior),
             is_touching = !matrix.is_empty(kBoundary, kBoundary);
  if (is_in && holds) return RegionRelation::kEqual;
  if (is_in) return is_touching ? RegionRelation::kCoveredBy : RegionRelation::kInside;
  if (holds) return is_touching ? RegionRelation::kCovers : RegionRelation::kContains;
  return RegionRelation::kOverlap;
}

const char* name_of(RegionRelation relation) {
  static constexpr const char* kNames[] = {"disjoint",   "meet",     "overlap", "covers",
                                           "covered_by", "contains", "inside",  "equal"};
  return kNames[static_cast<size_t>(relation) - 1];
}

}  // namespace jalon
