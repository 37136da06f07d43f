// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jalon {

constexpr double kRoughAngleError_rad = 1.2e-5;  ///< the polynomial's largest one is 1.15e-5

/// std::atan2(y, x) to that error, some times sooner: for angles that are only compared.
double rough_angle(double y, double x);

}  // namespace jalon
