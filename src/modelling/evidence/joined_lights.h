// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/evidence/opening_shape.h"

namespace jalon {

inline constexpr double kMullion_m = 0.2;    ///< wider are piers
inline constexpr double kMostLight_m = 1.3;  ///< of the narrower light

/// Lights of one window as one shape: rectangles side by side (or one over the other) of the same foot and head (left
/// and right), parted by a mullion (a transom) narrower than any pier. cell_m: of the shapes' cells; borders lie within
/// one of the truth.
std::vector<OpeningShape> joined_lights(std::vector<OpeningShape> shapes, double cell_m);

}  // namespace jalon
