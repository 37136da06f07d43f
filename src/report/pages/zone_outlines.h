// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison.h"
#include "model/model.h"

namespace jalon {

/// Of a comparison of method "landslide": a part "region 1" with the outline of each zone that points number (column
/// "region"), of class "depletion" or "accumulation", and parts "not measured in ..." with what one epoch or both
/// lack. Each piece lies on the plane that fits its cells, its corners above or below those of the grid. root: the
/// part above.
void add_zone_outlines(const Comparison& comparison, const FieldTable& points, uint32_t root,
                       Model& model);

}  // namespace jalon
