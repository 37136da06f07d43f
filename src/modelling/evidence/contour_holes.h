// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/polygon_sets.h"
#include "modelling/contour/contour.h"
#include "modelling/evidence/opening_shape.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// The shape's ring, its arcs as chords.
std::vector<Vec2> polygon_of(const OpeningShape& shape, double spacing_m);

PolygonWithHoles box_polygon(double left, double foot, double right, double head);

/// A region less others, as polygons without holes: those that lie inside it are joined to its border by upright slits.
std::vector<PolygonWithHoles> without(const std::vector<PolygonWithHoles>& region,
                                      std::vector<PolygonWithHoles> others, double spacing_m);

/// What openings at its border leave of a polygon. One that lies inside, so near to the border that nothing of the wall
/// is between, is joined to the border where that comes nearest; what stays a hole is farther inside.
std::vector<PolygonWithHoles> cut_out(const PolygonWithHoles& whole,
                                      std::span<const PolygonWithHoles> openings, double near_m);

/// From a hole to the polygon that fills it, and back.
Chain reversed_chain(Chain chain);

/// Of each opening the hole of a contour that has its form, to within two spacings of the points that border both, or
/// where the hole goes on its cells were seen through; empty where there is none. Such a hole tells the opening's
/// border point by point, a shape only cell by cell. Before: openings as large as the contour would draw them, apart
/// from each other.
std::vector<Chain> holes_of(const Contour& contour, std::span<const OpeningShape> openings,
                            const WallCells& cells);

/// Whether each of these openings has a hole of its own.
bool has_holes_for(const Contour& contour, std::span<const OpeningShape> openings);

/// Whether a contour shows these openings and no other: each one hole has its place, or nothing of the contour does (it
/// goes round an opening at its border).
bool shows(const Contour& contour, std::span<const OpeningShape> openings);

inline constexpr double kApart = 0.5;  ///< spacings between openings, and from them to the border

/// Corners no farther apart than a spacing.
Chain dense(std::span<const Vec2> polygon, double spacing_m);

/// Whether a polygon lies inside an outline, without a point of the outline inside or near it.
bool is_apart(const std::vector<Vec2>& polygon, const Chain& outline, double spacing_m);

/// Those whose box meets that of a ring.
std::vector<PolygonWithHoles> those_meeting(const Chain& ring,
                                            std::span<const PolygonWithHoles> polygons);

/// What openings at the border and their ways out leave of a piece, its own openings left out.
std::vector<ContourPiece> parts_left(const ContourPiece& piece,
                                     std::span<const PolygonWithHoles> cut, double spacing_m,
                                     const ContourSetting& setting);

/// Pieces less places at their border that nobody measured, each with the openings that still lie inside it.
std::vector<ContourPiece> cut_at_border(std::vector<ContourPiece> pieces,
                                        std::span<const PolygonWithHoles> cut, double spacing_m,
                                        const ContourSetting& setting);

}  // namespace jalon
