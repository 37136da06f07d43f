// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/vec.h"

namespace jalon {

/// The box near most points: that between the quartiles of each axis, and beyond it on all sides three times the widest
/// distance of quartiles. Stray points, and places far from where three quarters are, lie outside. points: not empty.
Box3 box_near_most(std::span<const Vec3> points);

}  // namespace jalon
