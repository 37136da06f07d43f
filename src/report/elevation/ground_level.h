// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/elevation/faces.h"

namespace jalon {

/// The lowest ground at the foot of the walls, from which heights count; without any near, the lowest point of the box,
/// which must be there. Level ground, a line on the drawing, has its mean height; a slope that of its plane where it
/// meets the main plane below the walls, as far as the slope itself reaches.
double ground_level(const ElevationFaces& faces, const Model& model, const ElevationView& view);

}  // namespace jalon
