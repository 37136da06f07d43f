// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "registration/targets/intensity_pattern.h"

namespace jalon {

/// Chance that what was fitted as a disc is one and no square, by its outline, of which noise and blur hide less than
/// they hide of its corners: what the disc leaves of the brightness about its border is developed into harmonics of
/// the angle, and each is a wave of the outline (Kuhl & Giardina 1982). A square of a disc's area has a fourth
/// harmonic; other shapes have a second or a third one.
///
/// Before: points relative to the disc's centre, as many residuals, of value = level + contrast (-1 outside, 1 inside)
/// less the value; contrast != 0. After: 0 ... 1; 1/2 where too few points lie about the border to tell.
double chance_of_disc(std::span<const BrightPoint> points, const std::vector<double>& residuals,
                      double radius_m, double contrast);

}  // namespace jalon
