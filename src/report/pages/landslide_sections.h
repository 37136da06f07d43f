// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "compare/comparison.h"
#include "report/sheet/html_page.h"

namespace jalon {

/// Chapter of a comparison of method "landslide": what went and what came, each with its standard deviation, how far
/// the boundary is known, and what no volume holds because it was not measured. Nothing for other methods.
void add_landslide(Page& page, const Comparison& comparison);
/// Whether that chapter tells this value of the summary.
bool is_told_of_landslide(std::string_view name);

}  // namespace jalon
