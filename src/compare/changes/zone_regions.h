// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/regions.h"

namespace jalon {

/// The zones of a comparison of method "landslide" as regions, with what their cells measure.
ChangeRegions zone_regions(const Comparison& comparison);

}  // namespace jalon
