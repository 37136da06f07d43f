// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/field.h"
#include "cloud/cloud.h"
#include "model/model.h"

namespace jalon {

/// What became of a point; the numbers of jalon/comparer.h. The first four are the labels of the visibility test
/// (Girardeau-Montaut 2006, algorithm 3), the best known first.
enum class CompareStatus : uint8_t {
  kCompared = 0,
  kHidden = 1,
  kOutOfRange = 2,
  kOutOfField = 3,
  kNothingNear = 4,   ///< no reference within max_distance_m
  kTooFewPoints = 5,  ///< too few points around it for a value
};
constexpr size_t kCompareStatuses = 6;

/// Result of a comparer: immutable, keeps the points that its rows belong to.
struct Comparison {
  CloudPtr cloud;  ///< the compared points, or the core points of method m3c2
  FieldTable
      points;  ///< one row a point: "distance" float64 (NaN unless compared), "status" uint8 ...
  FieldTable summary;  ///< one row
  FieldTable parts;    ///< one row a part of a reference model with parts; else without columns
  std::string parameters_json;
  std::shared_ptr<const void> kept;  ///< for a comparison the other way round
};
using ComparisonPtr = std::shared_ptr<const Comparison>;

}  // namespace jalon
