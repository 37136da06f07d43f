// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "cloud/cloud.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Standard deviation of the points across the noisiest surfaces that a cloud has much of, upright or level: what is
/// noise and not shape. Shape (reveals, mouldings, plants) spreads some neighbourhoods, noise all of them; so it is the
/// spread that three quarters of the neighbourhoods of either kind exceed, in neighbourhoods wide enough to be surfaces
/// in spite of it. 0: there are no surfaces. z is up.
double surface_noise_m(const Cloud& cloud, const Octree& tree, Task& task);

}  // namespace jalon
