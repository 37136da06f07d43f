// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec.h"
#include "segment/codes/coded_object.h"

namespace jalon {

/// How far inside the outline of the nearest coded building, negative outside; minus infinity without any.
double depth_in_buildings(const CodedObjects& objects, const Vec2& place);
/// Away from the building before whose wall a pipe stands; zero where none is near.
Vec2 way_out_at_pipe(const CodedObjects& objects, const Vec2& place);

}  // namespace jalon
