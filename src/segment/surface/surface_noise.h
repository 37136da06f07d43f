// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// The variances of a neighbourhood across it and along its narrower side, m^2; is it within 30 degrees of upright?
struct Spread {
  double across = 0, along = 0;
  bool upright = false;
  Vec3 normal = {};
};
/// Of the k nearest points about so many of the cloud's, evenly along the curve.
std::vector<Spread> neighbourhood_spreads(const Cloud& cloud, const Octree& tree, uint32_t k,
                                          size_t samples, Task& task);

/// Standard deviation of the points across the noisiest surfaces that a cloud has much of, upright or level: what is
/// noise and not shape. Shape (reveals, mouldings, plants) spreads some neighbourhoods, noise all of them; so it is the
/// spread that three quarters of the neighbourhoods of either kind exceed, in neighbourhoods wide enough to be surfaces
/// in spite of it. Where a twentieth of them hold smaller ones that face alike and are surfaces far less thick, what
/// the wider ones spread by is shape, as posts and bays in a coarse scan, and the noise that of the smaller. 0: there
/// are no surfaces. z is up.
double surface_noise_m(const Cloud& cloud, const Octree& tree, Task& task);

}  // namespace jalon
