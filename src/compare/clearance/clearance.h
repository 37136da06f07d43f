// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/field.h"
#include "base/params.h"
#include "cloud/cloud.h"
#include "compare/clearance/part_triangles.h"
#include "model/model.h"
#include "solid/convex_piece.h"

namespace jalon {

/// Throws kInvalidArgument where both tell a CRS and these differ.
void require_one_crs(const SharedText& a, const SharedText& b);

struct ClearanceSettings {
  double margin_m = 0.1;             ///< what comes this close is listed
  double reach_m = 1;                ///< of a sweep: the least clearance is found up to here
  double chord_m = 0.001;            ///< arcs of faces become chords this close to them
  double depth_tolerance_m = 0.005;  ///< of the depth in a closed surface that is not convex
};
/// Parameter table of operation "clearance".
std::span<const ParamRow> clearance_rows();

/// One row, and one row for each point or triangle within the margin; the columns are those of jalon/clearance.h.
struct ClearanceTables {
  FieldTable summary, near;
};
ClearanceTables clearance_to_cloud(const Model& model, uint64_t part, const Cloud& cloud,
                                   const ClearanceSettings& settings, Task& task);
ClearanceTables clearance_to_model(const Model& model, uint64_t part, const Model& other,
                                   uint64_t other_part, const ClearanceSettings& settings,
                                   Task& task);

struct SweepTables {
  FieldTable places, intervals;
};
/// cloud, model: either may be nullptr, not both.
SweepTables sweep_tables(std::span<const ConvexPiece> pieces, std::span<const Transform> poses,
                         const Cloud* cloud, const Model* model, const ClearanceSettings& settings,
                         Task& task);

}  // namespace jalon
