// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "modelling/evidence/opening_shape.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// Where points are looked at to fit a shape (in the plane's coordinates) to them.
RingBox fitting_window(const OpeningShape& shape, const WallCells& cells);

/// The shape of an opening by the points that border it: those of the wall and of what covers it (surrounds, panels),
/// where cells of 2.2 spacings tell a flat arch from a rectangle no more. Cells of half a spacing have a point or none;
/// each speaks for the opening or against it by the logarithm of how likely that is within and beside it, where one in
/// a hundred of the points of a wall strays into an opening. Kinds are compared as in fitted_shape.
///
/// solid: all such points in the window of the shape. Before: both in the plane's coordinates.
OpeningShape fitted_to_points(const OpeningShape& shape, const WallCells& cells,
                              std::span<const Vec2> solid);

}  // namespace jalon
