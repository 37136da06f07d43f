// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "report/charts/clearance_places.h"

namespace jalon {

/// Red: it touches. Orange: within the margin. Green: free.
const char* clearance_colour(double clearance_m, double margin_m);

/// The least clearance along the gauge's way as SVG, in metres of way, with the margin and the numbers of the tight
/// places; what is blank is above the axis. intervals: what jalon_gauge_sweep gives.
std::string clearance_chart(const FieldTable& intervals, const GaugePath& path,
                            std::span<const TightPlace> tight, double margin_m);

}  // namespace jalon
