// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/model.h"

// How the tree of parts becomes the products and relations of IFC4.
namespace jalon::ifc {

/// What a part is in the file.
enum class Role : uint8_t {
  kNothing,   ///< it has nothing to show and nothing below it does
  kBuilding,  ///< IfcBuilding
  kOpening,   ///< IfcOpeningElement in its wall, filled by a window, a door or what stands in it
  kWithin,    ///< shown as part of the window or door it belongs to
  kElement,   ///< IfcWall, IfcRoof ... or a proxy
  kGroup,     ///< IfcGroup of what is below it: facades, strips
};

/// Faces of a part and of those shown with it.
struct Shape {
  std::vector<uint32_t> solids;     ///< of Model::solids
  std::vector<uint32_t> faces;      ///< in no solid
  std::vector<uint32_t> triangles;  ///< that no face stands for
  bool empty() const { return solids.empty() && faces.empty() && triangles.empty(); }
};

/// A hole of a face.
struct Hole {
  uint32_t face = 0;
  uint64_t ring = 0;
};

/// Vectors have an entry a part, and one more for what belongs to none.
struct Products {
  std::vector<Role> roles;
  std::vector<Shape> shapes;             ///< of buildings, elements, and what fills an opening
  std::vector<std::vector<Hole>> holes;  ///< of openings
  std::vector<uint32_t> hosts;           ///< of openings: the part whose faces have the holes
  std::vector<uint32_t> buildings;       ///< the nearest above (or itself); kNoPart: in none
  std::vector<std::vector<uint32_t>> members;  ///< of groups: elements and groups straight below
};

Products arrange_products(const Model& model);

/// Name of the entity for an element of this class, and the word of its last attribute.
struct Entity {
  const char* name;
  const char* type;
};
Entity entity_of(std::string_view part_class);

}  // namespace jalon::ifc
