// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/model.h"

// How the tree of parts and the semantic surfaces of CityJSON 2.0 (specification 3.3.2, "Semantics of geometric
// primitives") stand for each other.
namespace jalon::city {

/// Semantic surface of a part: WallSurface, RoofSurface, GroundSurface, Window, Door, ClosureSurface (other openings);
/// joinery has that of the opening it stands in. Sills, cornices and other elements are surfaces of the wall: their
/// class stays an attribute.
const char* surface_type(const Model& model, uint32_t part);
/// Class of a part that a semantic surface becomes; kElement for types that have no counterpart.
const char* class_of_surface(std::string_view type);
/// "Building" and "BuildingPart" -> "building", "TINRelief" -> "tin_relief".
std::string class_of_object(std::string_view type);

/// The nearest of the part and its ancestors of this class; kNoPart when there is none.
uint32_t nearest(const Model& model, uint32_t part, const char* part_class);

/// What the holes of the walls tell of their openings.
struct Openings {
  std::vector<uint32_t>
      wall;  ///< of each part: the part of the face with the hole that it fills, or kNoPart
  std::vector<uint8_t>
      filled;  ///< of each part: it or a part of it has a face that closes the hole
};
Openings find_openings(const Model& model);

}  // namespace jalon::city
