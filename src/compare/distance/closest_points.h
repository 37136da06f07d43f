// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "cloud/cloud.h"
#include "compare/comparison.h"

namespace jalon {

/// The reference points that are nearest to a compared point of a comparison by method "distance", each once, in the
/// reference's order, with their fields.
Cloud closest_points(const Comparison& comparison, const Cloud& reference, Task& task);

}  // namespace jalon
