// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/task.h"
#include "model/model.h"

namespace jalon::city {

/// The vertices of a CityJSON file: whole steps from a corner of whole metres, each place once.
class Grid {
 public:
  Grid(const Model& model, double scale_m);

  uint32_t add(const Vec3& p);
  double scale_m() const { return scale_m_; }
  const Vec3& translate() const { return translate_; }
  const std::vector<std::array<int64_t, 3>>& steps() const { return steps_; }
  Vec3 place(uint32_t index) const;

 private:
  struct Hash {
    size_t operator()(const std::array<int64_t, 3>& s) const;
  };
  double scale_m_;
  Vec3 translate_;
  std::vector<std::array<int64_t, 3>> steps_;
  std::unordered_map<std::array<int64_t, 3>, uint32_t, Hash> index_;
};

/// A polygon with holes and the part whose semantic surface it belongs to.
struct Surface {
  std::vector<std::vector<uint32_t>> rings;
  uint32_t part = kNoPart;
};

/// A MultiSurface, or a Solid of one shell.
struct Geometry {
  bool solid = false;
  std::vector<Surface> surfaces;
};

/// One CityObject and what belongs to it.
struct Object {
  uint32_t part = kNoPart;    ///< the building; kNoPart: what stands in none
  uint32_t parent = kNoPart;  ///< the building that it is a part of
  std::vector<Geometry> geometries;
};

struct City {
  std::map<uint32_t, Object> objects;  ///< by their part
  std::vector<uint8_t> closing;  ///< of each part: its surface was made to close the hole of a wall
  std::vector<std::vector<uint32_t>> faces_of_part;
  std::vector<uint32_t> wall_of_opening;  ///< find_openings
  size_t dropped = 0;                     ///< faces too small for the grid
  bool has_openings = false;
};

/// The faces, triangles and solids of a model without arcs, sorted into buildings.
City arrange(const Model& model, Grid& grid, Task& task);

}  // namespace jalon::city
