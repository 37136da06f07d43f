// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "base/task.h"
#include "compare/comparison.h"
#include "model/model.h"

namespace jalon {

/// Parameter table of operation "change_outlines".
std::span<const ParamRow> change_outlines_rows();

/// A comparison and the table of its points that has the column "region" and, after a diagnosis, "change".
struct ChangedCloud {
  const Comparison* comparison = nullptr;
  const FieldTable* points = nullptr;
};

/// Outlines of the change regions, each on the plane through its points: a part "region 3" with a face for each
/// connected piece of its surface. before: of the comparison the other way round, or with nulls. changes: the table of
/// the diagnosis, whose classes the parts get; without it they are of class "region".
Model change_outlines(const ChangedCloud& after, const ChangedCloud& before, const FieldTable* changes,
                      const ParamSet& options, Task& task);

}  // namespace jalon
