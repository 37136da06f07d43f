// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "model/model.h"

namespace jalon {

/// Everything of a model that a point can lie on, as triangles: its faces (openings stay open, arcs become chords) and
/// those triangles of its mesh that stand for no face.
class ModelSurface {
 public:
  /// Where a triangle comes from. kNoFace and kNoPart: from none.
  struct Source {
    uint32_t face;      ///< row of the model's faces
    uint32_t triangle;  ///< row of the model's triangles
    uint32_t part;
  };

  /// The model must outlive the surface. kInsufficientData when there is nothing to lie on.
  ModelSurface(const Model& model, double chord_error_m, Task& task);

  std::span<const Vec3> vertices() const {
    return chorded_.vertices.empty() ? model_.vertices : chorded_.vertices;
  }
  std::span<const std::array<uint32_t, 3>> triangles() const {
    return has_faces_ ? triangles_ : model_.triangles;
  }
  Source source(uint32_t triangle) const;

 private:
  void add_faces(const Model& model, Task& task);
  void add_loose_triangles();

  const Model& model_;
  Model chorded_;   ///< empty when the model has no arcs
  bool has_faces_;  ///< the model has faces; else its triangles are taken as they are
  bool mesh_by_part_;
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<uint32_t> rows_;  ///< of each of triangles_: the row of its face, or of its triangle
  size_t of_faces_ = 0;         ///< so many of the first are of faces
};

}  // namespace jalon
