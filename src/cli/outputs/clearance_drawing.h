// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace jalon::cli {

/// The least clearance of each pose interval along the trajectory as SVG text, with the margin and the contacts.
/// clearances: NaN where nothing is within reach_m. unit: how lengths are labelled.
std::string clearance_drawing(const std::vector<double>& clearances, double margin_m,
                              double reach_m, const std::string& unit);

}  // namespace jalon::cli
