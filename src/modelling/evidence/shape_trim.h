// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/evidence/opening_shape.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// Takes a rectangle apart where it does not look like an opening: at bands across it in which nothing was seen, while
/// things were seen through the rest, and that go on beside it where its jamb or lintel would be (what canopies and
/// signs hide). In cells; the shape itself where there is no such band, and for other kinds.
std::vector<OpeningShape> parts_of(const WallCells& cells, const OpeningShape& shape);

}  // namespace jalon
