// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/sphere.h"

namespace jalon {

/// Noise along the rays moves the points of a sphere along its surface too, so that a point that is
/// off outward counts as nearer to the scanner than it is: least squares on the distances puts the
/// centre toward the scanner, by 0.2 mm for 2 mm of noise and a radius of 72 mm when the radius is
/// free, as much as its standard deviation. (The regressors' errors correlate with the residuals:
/// Carroll et al. 2006, chapter 3.) Takes the expectation of that off; the variance along the rays
/// is the part of the squared distances that grows with the squared cosine of incidence, so that
/// noise of another kind changes nothing.
///
/// Before: fitted is the least squares fit to the points, sigma_m their noise; rays: unit vectors
/// from the points to the scanner, one each. After: the radius as it was where it is known.
Sphere without_ray_bias(std::span<const Vec3> points, std::span<const Vec3> rays,
                        const Sphere& fitted, double sigma_m, bool radius_known);

}  // namespace jalon
