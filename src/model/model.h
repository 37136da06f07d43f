// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/plane.h"
#include "geometry/vec.h"

namespace jalon {

/// A closed chain of vertices: corners[first ... first + count).
struct Ring {
  uint64_t first = 0, count = 0;
};

/// A planar face: one outline (counter-clockwise seen against the normal), then its openings (clockwise).
struct Face {
  uint32_t part = 0;
  uint64_t first_ring = 0, ring_count = 0;
  uint32_t id = 0;           ///< e.g. the label of the segment it was made from
  uint8_t face_class = 0;    ///< orientation class of segment/, or 0
  Plane plane;
  double area_m2 = 0;        ///< openings taken off
  double sigma_m = 0;
  std::array<double, 16> covariance{};  ///< of normal and offset
};

constexpr uint64_t kNoParent = ~uint64_t{0};

/// Node of the tree of parts: building block -> facade -> wall, opening ...
struct Part {
  std::string name;
  std::string part_class;
  uint64_t parent = kNoParent;
};

/// Vector model: a value; shared as shared_ptr<const Model>. Faces and triangles use the same vertices.
struct Model {
  std::vector<Vec3> vertices;
  std::vector<uint32_t> corners;  ///< vertex of each ring corner
  std::vector<Ring> rings;
  std::vector<Face> faces;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint32_t> triangle_faces;  ///< id handed on to scanned points, one a triangle
  std::vector<Part> parts;

  /// Appends a face from rings of points; equal vertices are not merged. Returns its index.
  size_t add_face(Face face, const std::vector<std::vector<Vec3>>& rings);
};

using ModelPtr = std::shared_ptr<const Model>;

/// Throws kInvalidArgument when an index or a coordinate is impossible; cost O(size).
void validate(const Model& model);

}  // namespace jalon
