// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/model_surface.h"

#include "base/error.h"
#include "base/parallel.h"
#include "model/chords.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

constexpr size_t kFaceGrain = 64;  // faces a chunk: some ms when they have hundreds of corners

}  // namespace

ModelSurface::ModelSurface(const Model& model, double chord_error_m, Task& task)
    : model_(model), has_faces_(!model.faces.empty()), mesh_by_part_(is_mesh_by_part(model)) {
  if (has_arcs(model)) chorded_ = with_chords(model, chord_error_m);
  if (has_faces_) {
    add_faces(chorded_.vertices.empty() ? model : chorded_, task);
    add_loose_triangles();
  }
  if (triangles().empty())
    fail(Status::kInsufficientData, "the model has no faces and no triangles");
}

void ModelSurface::add_faces(const Model& model, Task& task) {
  std::vector<std::vector<std::array<uint32_t, 3>>> of_face(model.faces.size());
  parallel_for(task, model.faces.size(), kFaceGrain, [&](size_t begin, size_t end) {
    for (size_t f = begin; f < end; ++f) of_face[f] = triangles_of_face(model, model.faces[f]);
  });
  for (uint32_t f = 0; f < of_face.size(); ++f) {
    triangles_.insert(triangles_.end(), of_face[f].begin(), of_face[f].end());
    rows_.resize(triangles_.size(), f);
  }
  of_faces_ = triangles_.size();
}

void ModelSurface::add_loose_triangles() {
  for (const uint32_t t : loose_triangles(model_)) {
    triangles_.push_back(model_.triangles[t]);
    rows_.push_back(t);
  }
}

ModelSurface::Source ModelSurface::source(uint32_t triangle) const {
  if (triangle < of_faces_) return {rows_[triangle], kNoFace, model_.faces[rows_[triangle]].part};
  const uint32_t row = has_faces_ ? rows_[triangle] : triangle;
  return {kNoFace, row, mesh_by_part_ ? model_.triangle_faces[row] : kNoPart};
}

}  // namespace jalon
