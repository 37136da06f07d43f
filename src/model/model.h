// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/numbers.h"
#include "base/shared_text.h"
#include "geometry/plane.h"
#include "geometry/vec.h"

namespace jalon {

constexpr uint64_t kNoParent = ~uint64_t{0};
constexpr uint32_t kNoPart = ~uint32_t{0};
constexpr uint32_t kNoFace =
    ~uint32_t{0};  ///< of points that no face gave, of an edge at the border

/// A closed chain of vertices: corners[first ... first + count).
struct Ring {
  uint64_t first = 0, count = 0;
  uint32_t part = kNoPart;  ///< the opening (window, door ...) that fills this hole of the face
};

/// A planar face: one outline (counter-clockwise seen against the normal), then its openings (clockwise).
struct Face {
  uint32_t part = 0;
  uint64_t first_ring = 0, ring_count = 0;
  uint32_t id = 0;         ///< e.g. the label of the segment it was made from
  uint8_t face_class = 0;  ///< orientation class of segment/, or 0
  Plane plane;
  double area_m2 = 0;  ///< openings taken off
  double sigma_m = 0;
  std::array<double, 16> covariance{};  ///< of normal and offset
};

/// How a part of the model is known; the numbers of jalon/model.h.
enum class Evidence : uint8_t {
  kNone = 0,        ///< not told
  kMeasured = 1,    ///< points lie on it
  kSeenBehind = 2,  ///< an opening: points were seen through it, behind the wall
  kRevealed = 3,    ///< an opening: its reveals were measured
  kShape = 4,       ///< an opening by its shape alone: nothing was seen through it
  kCopied = 5,      ///< a copy of a repeated element where data are missing
  kDerived = 6,     ///< follows from other parts: a reveal face, the side of an extrusion
};

/// "measured", "seen_behind", ... ; "none" for kNone. The other way round: kNone for a word that is none of them.
const char* name_of(Evidence evidence);
Evidence evidence_named(std::string_view name);

/// Node of the tree of parts: building block -> facade -> wall, opening ...
struct Part {
  std::string name;
  std::string part_class;  ///< one of part_classes.h, or any other word
  uint64_t parent = kNoParent;
  double width_m = kNaN;  ///< of its upright box in the plane of its wall
  double height_m = kNaN;
  double depth_m = kNaN;             ///< behind the plane of its wall, negative in front
  uint64_t copied_from = kNoParent;  ///< the part it repeats
  uint8_t level_of_detail = 0;  ///< CityGML 3: 2 walls and roofs, 3 with openings; 0 = not told
  Evidence evidence = Evidence::kNone;
  /// Probability that the class is right where it was told from measurements; of "opening" that of the likeliest one,
  /// which is too small to be said; NaN: not told.
  double class_confidence = kNaN;
};

/// Faces that bound a volume together: faces[first_face ... first_face + face_count), their normals outward.
struct Solid {
  uint32_t part = 0;
  uint64_t first_face = 0, face_count = 0;
};

/// Vector model: a value; shared as shared_ptr<const Model>. Faces and triangles use the same vertices.
struct Model {
  std::vector<Vec3> vertices;
  std::vector<std::array<double, 9>>
      vertex_covariances;         ///< m2, row-major; empty, or one a vertex (NaN: not known)
  std::vector<uint32_t> corners;  ///< vertex of each ring corner
  /// Sagitta (m) of the edge from each corner to the next of its ring: 0 = straight; positive = an arc that runs
  /// anticlockwise seen against the face's normal (it bulges to the right of the walk). Empty, or one a corner.
  std::vector<double> sagittas;
  std::vector<Ring> rings;
  std::vector<Face> faces;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint32_t> triangle_faces;  ///< id handed on to scanned points, one a triangle
  std::vector<Part> parts;
  std::vector<Solid> solids;
  SharedText
      crs;  ///< coordinate reference system of the vertices, as Cloud::crs (WKT, a URN ...); empty: not known

  double sagitta(size_t corner) const { return sagittas.empty() ? 0 : sagittas[corner]; }
  /// Appends a face from rings of points; equal vertices are not merged. Returns its index.
  size_t add_face(Face face, const std::vector<std::vector<Vec3>>& rings);
};

using ModelPtr = std::shared_ptr<const Model>;

/// Throws kInvalidArgument when an index or a coordinate is impossible; cost O(size).
void validate(const Model& model);

}  // namespace jalon
