// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "modelling/contour/contour.h"
#include "modelling/evidence/find_openings.h"

namespace jalon {

/// The contour of a wall whose openings are known: what is left of it is wall or was not looked at.
/// 1. Points in openings (leaves and frames flush with the wall) go; a rim of points is put inside each opening, and
///    some where relief covers the wall, so that it goes on over them.
/// 2. The contour of these points (contour.h).
/// 3. Openings inside a piece are its openings; those at its border are cut out of its outline, through to the outside.
/// 4. Holes of the contour that are no openings keep what openings leave of them: nothing was measured there. Above an
///    opening at the border such a place goes down to its head, else wall stays between both.
///
/// Before: candidates in the coordinates of the points; plain: the contour of all of them. An opening that one of its
/// holes shows is drawn by it. After: as of extract_contour; openings have the corners of
/// their shape, a set-back outside of it, as a contour drawn round them would.
Contour drawn_contour(std::span<const Vec2> points, std::span<const OpeningCandidate> candidates,
                      const Contour& plain, const WallCells& cells, const ContourSetting& setting,
                      const ForeignTest& foreign, Task& task);

}  // namespace jalon
