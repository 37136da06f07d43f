// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/buildings/building_tree.h"
#include "model/buildings/vertical_pieces.h"

namespace jalon {

/// Facades of the pieces: each face is one; triangles of a bare mesh are joined where they lie in one
/// plane (1 degree, 2 cm) of one building and touch. Shorter ones than least_length_m are left out.
std::vector<BuildingFacade> facades_of(const VerticalPieces& pieces, double least_length_m);

/// Turns those whose normals look inward, by the footprint that the facades of their building make:
/// from outside a line leaves it an even number of times. Where the footprint is open, such as a
/// single wall, the normal stays.
void turn_outward(std::vector<BuildingFacade>& facades);

/// Blocks: buildings that touch, from one to the next. Two touch where their footprints come as near
/// as touch_m; without corners they must run along each other.
struct Blocks {
  uint32_t count = 0;
  std::vector<uint32_t> of_building;
};
Blocks blocks_of(const std::vector<BuildingFacade>& facades, size_t buildings, double touch_m,
                 bool corners);

/// Where strips begin and end along a facade: n + 1 numbers for n strips.
std::vector<double> strip_cuts(double from_m, double to_m, double width_m,
                               StripRemainder remainder);
std::vector<BuildingStrip> strips_of(const BuildingFacade& facade, uint32_t number,
                                     const BuildingSettings& settings);

}  // namespace jalon
