// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/task.h"
#include "geometry/polygon_sets.h"
#include "model/model.h"
#include "modelling/plane/plane_frame.h"

namespace jalon {

/// What of a model is compared with the other, polygon by polygon.
struct FaceChoice {
  bool openings = false;  ///< the holes of faces, each a polygon, instead of the faces
  bool by_plane = false;  ///< coplanar faces together are one
  double min_area_m2 = 0;
  double angle_rad = 0, distance_m = 0;  ///< within which planes are the same
  double corner_angle_rad = 0;  ///< least turn of a ring at a corner that counts as a vertex
  std::vector<std::string> classes, ignored_classes;  ///< of the faces' parts; no classes: all
};

/// A face, an opening or coplanar faces, in their own plane.
struct ComparedFace {
  uint32_t face =
      0;  ///< row of the model's face, of the largest of several; of a mesh its triangle
  uint32_t ring = ~uint32_t{0};  ///< row of the ring, of an opening
  uint32_t part = 0;
  uint32_t merged = 1;                   ///< how many faces it stands for
  PlaneFrame frame;                      ///< about its middle
  std::vector<PolygonWithHoles> region;  ///< in the frame; arcs as chords within the polygons' grid
  std::vector<uint32_t> vertices;  ///< corners that count, of the model, in the order of the rings
  double area_m2 = 0;
  Box3 box;
  bool kept = true;  ///< false: too small
};

/// The polygons to compare, in the order of the model; faces of other classes and those without an area (fewer than 3
/// corners, collinear ones) are not among them. Coordinates relative to origin. A model without faces gives its
/// triangles, coplanar ones together. O(corners), by plane O(faces x planes).
std::vector<ComparedFace> compared_faces(const Model& model, const Vec3& origin,
                                         const FaceChoice& choice, Task& task);

/// The face's region in another plane's frame, moved by shift first: projected along that plane's
/// normal.
std::vector<PolygonWithHoles> region_in(const PlaneFrame& frame, const ComparedFace& face,
                                        const Vec3& shift);

/// Is the middle of a face, moved by shift, within the tolerances of the reference's plane?
bool on_plane_of(const ComparedFace& reference, const ComparedFace& face, const Vec3& shift,
                 const FaceChoice& choice);
/// Of the middle of a face, moved by shift, along the reference's normal.
double plane_distance(const ComparedFace& reference, const ComparedFace& face, const Vec3& shift);

/// Angle between planes, whichever way their normals point: 0 ... pi / 2.
double plane_angle(const Vec3& a, const Vec3& b);

}  // namespace jalon
