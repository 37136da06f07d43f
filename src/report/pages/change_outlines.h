// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "base/task.h"
#include "compare/comparison.h"
#include "model/model.h"

namespace jalon {

/// Operation "change_outlines".
struct ChangeOutlineSettings {
  double max_edge_m = 0;           ///< 0 = twice what joined the points of a region
  double min_opening_area_m2 = 0;  ///< 0 = the square of the widest gap
};
std::span<const ParamRow> change_outlines_rows();

/// A comparison and the table of its points that has the column "region" and, after a diagnosis, "change".
struct ChangedCloud {
  const Comparison* comparison = nullptr;
  const FieldTable* points = nullptr;
};

/// Outlines of the change regions, each on the plane through its points: a part "region 3" with a face for each
/// connected piece of its surface. before: of the comparison the other way round, or with nulls. changes: the table of
/// the diagnosis, whose classes the parts get; without it they are of class "region".
Model change_outlines(const ChangedCloud& after, const ChangedCloud& before,
                      const FieldTable* changes, const ChangeOutlineSettings& settings, Task& task);

}  // namespace jalon
