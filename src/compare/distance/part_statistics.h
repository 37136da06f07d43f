// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "base/field.h"
#include "base/task.h"

namespace jalon {

/// The check of a model part by part (Girardeau-Montaut 2006, 5.1 and 5.3.1): one row a part; points without a distance
/// (NaN) or a part count nowhere. Columns: "part" (uint32), "points" (uint64), "mean", "sigma", "minimum", "maximum",
/// "maximum_absolute" (float64, m; NaN without points), and with tolerance_m > 0 "within_tolerance" (uint64),
/// "tolerance_share" (float64).
FieldTable part_statistics(std::span<const double> distances, std::span<const uint32_t> parts,
                           size_t part_count, double tolerance_m, Task& task);

}  // namespace jalon
