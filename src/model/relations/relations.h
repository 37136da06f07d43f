// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/field.h"
#include "base/params.h"
#include "base/task.h"
#include "geometry/nine_intersection.h"
#include "geometry/vec.h"
#include "model/model.h"

namespace jalon {

/// The parameters of operation "relations".
struct RelationSettings {
  enum class Elements { kParts, kFaces, kSolids };
  Elements elements = Elements::kParts;
  double tolerance_m = 0.001;   ///< what surveyors tell apart on a facade
  double max_distance_m = 0.5;  ///< of a pair that is listed
};
std::span<const ParamRow> relation_rows();

/// How two elements of a model lie to each other (Boulaassal 2010, 5.6.3.3).
struct Relation {
  uint32_t first = 0, second = 0;  ///< rows of the parts, faces or solids; first < second
  NineIntersection matrix;
  double distance_m = 0;
  uint8_t direction = 0;  ///< DirectionBits: where the second lies from the first
  Vec3 offset_m;          ///< of the middles of their boxes, to the right, up and out
};

/// Relations of all pairs up to max_distance_m apart, ascending by (first, second). Same for any number of threads.
/// Throws kInsufficientData where the model has none of the elements. O(n^2) box tests + the edges of near pairs.
std::vector<Relation> find_relations(const Model& model, const RelationSettings& settings,
                                     Task& task);

/// The table of jalon/model.h.
FieldTable relation_table(const std::vector<Relation>& relations);

}  // namespace jalon
