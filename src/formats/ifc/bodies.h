// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "formats/ifc/products.h"
#include "formats/ifc/step_file.h"
#include "model/model.h"

namespace jalon::ifc {

/// Writes the geometry of products, in coordinates from a stated origin. The model has no arcs.
class Bodies {
 public:
  Bodies(const Model& model, const Vec3& origin, StepFile& file)
      : model_(model), origin_(origin), file_(file) {}

  /// Faces as one open set with their holes, each solid as a closed set, triangles as one set.
  std::vector<Id> items_of(const Shape& shape);
  /// A wall of this thickness behind its faces: a closed prism each. Holes that are openings are left to those.
  std::vector<Id> walls_of(const Shape& shape, double thickness_m);
  /// Of an opening: its holes as flat polygons.
  std::vector<Id> outlines_of(const std::vector<Hole>& holes);
  /// Of an opening: what it takes out of a wall of this thickness, a little longer at both ends.
  std::vector<Id> cuts_of(const std::vector<Hole>& holes, double thickness_m);
  /// Volume of a solid of the model, m3 (divergence theorem).
  double volume_m3(uint32_t solid) const;

 private:
  using Loop = std::vector<uint32_t>;  ///< places in the list, from 0
  struct Polygon {
    std::vector<Loop> loops;  ///< the outline, then its holes
  };
  /// The points of one face set.
  struct Points {
    std::vector<Vec3> places;
    std::map<uint32_t, uint32_t> of_vertex;
  };

  Loop loop_of(Points& points, const Ring& ring) const;
  void add_face(Points& points, std::vector<Polygon>& polygons, uint32_t face) const;
  Id prism(const std::vector<std::vector<Vec3>>& rings, const Vec3& along);
  std::vector<Vec3> corners_of(const Ring& ring) const;
  Id face_set(const Points& points, const std::vector<Polygon>& polygons, bool is_closed);
  Id point_list(const std::vector<Vec3>& places);

  const Model& model_;
  Vec3 origin_;
  StepFile& file_;
};

}  // namespace jalon::ifc
