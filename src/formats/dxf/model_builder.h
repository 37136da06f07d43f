// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "formats/dxf/shapes.h"
#include "formats/equal_vertices.h"
#include "formats/settings.h"
#include "model/model.h"

namespace jalon::dxf {

/// A model from the shapes of a drawing: a part a layer, closed polylines as faces, meshes as triangles. Rings that our
/// own files tell to be of one face are its outline and its holes again, with their parts.
class ModelBuilder {
 public:
  ModelBuilder(Polygons polygons, double metres_a_unit)
      : polygons_(polygons), scale_(metres_a_unit) {}

  void add(Loop loop);
  void add(Patch patch);
  Model take();

 private:
  struct Outline {
    uint32_t face = 0;
    std::vector<Vec3> corners;
    bool is_open = false;  ///< there is one
  };

  uint32_t part_of_layer(const std::string& layer);
  uint32_t part_told(const Told& told, const std::string& layer);
  bool is_hole_of_last(const Loop& loop, const Vec3& normal) const;
  void add_face(Loop loop, const Vec3& normal, uint32_t part, uint32_t id);
  void add_hole(Loop loop, uint32_t part);
  void add_ring(const Loop& loop, uint32_t part);

  Polygons polygons_;
  double scale_;
  Model model_;
  EqualVertices vertices_{model_};
  std::map<std::string, uint32_t> layers_;
  std::map<int64_t, uint32_t> told_parts_;  ///< by their number in the model that was written
  Outline last_;
};

}  // namespace jalon::dxf
