// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/field.h"
#include "base/task.h"

namespace jalon {

/// The summary row that every method gives: "points", "compared", "hidden", "out_of_range", "out_of_field",
/// "nothing_near", "too_few_points" (uint64), "mean", "rms", "sigma", "minimum", "maximum" (float64, m; of the compared
/// points, NaN without any). Methods append their own columns. The same bits for any number of threads.
FieldTable summarise(std::span<const double> distances, std::span<const uint8_t> statuses,
                     Task& task);

}  // namespace jalon
