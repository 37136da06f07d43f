// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/surface/planes.h"

namespace jalon {

/// The same surface without the planes that turn when three times as many neighbours are asked: of points in lines, few
/// neighbours lie on two or three of these, and those of a rough thing on a plane by chance. O(n k).
SurfacePlanes steady_planes(const SurfacePlanes& surface, uint32_t k, Task& task);

}  // namespace jalon
