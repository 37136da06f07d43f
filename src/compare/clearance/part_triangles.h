// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/vec.h"
#include "model/model.h"
#include "solid/convex_piece.h"

namespace jalon {

constexpr uint64_t kNoRow = ~uint64_t{0};
constexpr uint64_t kWholeModel = ~uint64_t{0};

/// Where a triangle comes from: a row of the model's faces or of its triangles; kNoRow where it has none.
struct TriangleSource {
  uint64_t part = kNoRow, face = kNoRow, triangle = kNoRow;
};

/// The surface of a part as triangles, with no vertices but theirs.
struct PartTriangles {
  std::vector<Vec3> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<TriangleSource> sources;  ///< one a triangle
};

/// Faces and triangles of a part and of all parts below it, or of the whole model. Arcs become chords at most chord_m
/// from them. Triangles belong to a part where their numbers are parts (a mesh without faces), else to the whole
/// alone. Throws kInvalidArgument for a part that is not there, kInsufficientData for one without a surface.
PartTriangles triangles_of_part(const Model& model, uint64_t part, double chord_m);

/// One convex piece for each part that has a surface of its own, in their order; one for all without parts. Throws
/// kInvalidArgument naming a part that is not convex, kDegenerate a flat one.
std::vector<ConvexPiece> gauge_of_model(const Model& model, double chord_m);
/// The corners of the same pieces, whose hulls they are, convex or not: for drawings.
std::vector<std::vector<Vec3>> gauge_corners(const Model& model, double chord_m);

}  // namespace jalon
