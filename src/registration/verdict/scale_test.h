// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/verdict/sights.h"

namespace jalon {

/// The scale that the moving cloud would like to have at a pose, as a seventh unknown beside it.
struct ScaleTest {
  double scale = 1;
  double sigma = 0;  ///< 0: too few pairs to tell
  size_t pairs = 0;
};
/// One step of least squares, point to plane, on the surfels of the moving cloud and their neighbours. O(surfels log
/// n).
ScaleTest scale_test(const JudgedCloud& reference, const JudgedCloud& moving,
                     const Transform& T_reference_moving);

}  // namespace jalon
