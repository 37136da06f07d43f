// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "formats/dxf/group_reader.h"
#include "geometry/vec.h"
#include "model/model.h"

// What a drawing holds of surfaces, as it is written: of a block or of the model space.
namespace jalon::dxf {

/// What our own files tell of a ring as application data.
struct Told {
  bool is_ours = false;
  uint32_t face = 0;
  int64_t number = -1;  ///< of the part in the model that was written; -1: none
  Part part;
};

/// A closed polyline. bulge: tangent of a quarter of the angle of the arc from a corner to the next, positive when it
/// runs anticlockwise seen against the normal.
struct Loop {
  std::string layer;
  std::vector<Vec3> corners;
  std::vector<double> bulges;  ///< one a corner
  Vec3 normal;                 ///< of the object coordinates; zero: corners stand in space
  Told told;
};

/// Polygons of a mesh: 3DFACE, polygon and polyface meshes, MESH.
struct Patch {
  std::string layer;
  std::vector<Vec3> corners;
  std::vector<std::vector<uint32_t>> polygons;
};

/// INSERT: a block, once or in rows and columns.
struct Insert {
  std::string layer, block;
  Vec3 at, scale{1, 1, 1}, normal{0, 0, 1};
  double rotation_rad = 0;
  int64_t columns = 1, rows = 1;
  double column_step = 0, row_step = 0;
};

struct Shapes {
  Vec3 base;  ///< of a block: the point that INSERT places
  std::vector<Loop> loops;
  std::vector<Patch> patches;
  std::vector<Insert> inserts;
  std::map<std::string, size_t> left_out;  ///< entities by their name
};

/// Reads the entity whose name the groups have just given; behind it they stand before the next group 0.
void read_entity(GroupReader& groups, Shapes& shapes);

}  // namespace jalon::dxf
