// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/codes/shared_faces.h"

namespace jalon {

/// Adds a pipe about an axis that may bend, as a closed solid of planar sides: mitred where it bends, its sides within
/// chord_m of the round. An axis that turns back on itself ends there.
void add_coded_pipe(SharedFaces& faces, uint32_t part, uint32_t id, const std::vector<Vec3>& axis,
                    double radius_m, double chord_m);

}  // namespace jalon
