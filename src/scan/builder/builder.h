// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/random.h"
#include "model/model.h"

namespace jalon {

/// Plane frame of a face: points origin + u * s + v * t; u, v orthonormal; the face looks along u x v.
struct Frame {
  Vec3 origin, u, v;
  Vec3 normal() const { return cross(u, v); }
  Vec3 point(double s, double t, double height = 0) const {
    return origin + u * s + v * t + normal() * height;
  }
  /// The parallel frame this far along the normal.
  Frame raised(double height) const { return {origin + normal() * height, u, v}; }
};

/// Closed range of a face's own coordinates.
struct Rect {
  double u0, u1, v0, v1;
  double width() const { return u1 - u0; }
  double height() const { return v1 - v0; }
};

/// A closed chain of corners in the face's own coordinates.
using Outline = std::vector<Vec2>;

Outline outline_of(const Rect& rect);
/// The rectangle under a round head that rises this much above its springing line, at most half the width: a
/// segmental arch, or a semicircle. Chords stay within 0.1 mm of the arc.
Outline arched_outline(const Rect& rect, double rise_m);

/// Makes scenes: every planar face gets its true plane, its rings and its triangles; ids count from 1.
class SceneBuilder {
 public:
  /// T_world_scene places the scene.
  explicit SceneBuilder(const Transform& T_world_scene) : T_world_scene_(T_world_scene) {}

  uint32_t part(std::string name, std::string part_class, uint64_t parent = kNoParent);
  uint32_t new_id() { return next_id_++; }

  /// The rectangle without the openings, which may touch its border but must leave one connected piece. id 0 = a new
  /// one. Gives the id back. Neighbouring triangles share whole edges.
  uint32_t face(uint32_t part, const Frame& frame, const Rect& outline,
                std::span<const Rect> openings = {}, uint32_t id = 0);

  /// Any outline, counter-clockwise, without the openings, which lie inside it and apart from each other.
  uint32_t polygon_face(uint32_t part, const Frame& frame, const Outline& outline,
                        const std::vector<Outline>& openings = {});

  /// What lies behind an opening of the frame's plane: a pane at this depth, and the four reveals (three without a
  /// sill).
  void recess(uint32_t part, const Frame& frame, const Rect& opening, double depth_m, bool has_sill,
              double frame_m, uint32_t pane_id = 0);

  /// The same with a round head: at the depth a joinery frame of 8 cm with glass 2 cm behind it, or one closed pane;
  /// sill, jambs, and the curved reveal of the head, which is no plane.
  void arched_recess(uint32_t part, const Frame& frame, const Rect& opening, double rise_m,
                     double depth_m, bool has_joinery);

  /// The strip that a path of the frame's plane sweeps between two heights over it, without a face: a curved surface,
  /// seen from the left of the path.
  void swept(const Frame& frame, const Outline& path, double low_m, double high_m);

  /// Upright or lying box seen from outside; without its bottom where it stands on something.
  void box(uint32_t part, const Vec3& corner, const Vec3& size, bool has_bottom);

  /// Curved surfaces: triangles of one id, without a face.
  void cylinder(const Vec3& foot, double radius_m, double height_m, int facets);
  void sphere(const Vec3& centre, double radius_m, int facets);
  /// A ground: two triangles a cell of columns x rows, with the corner (i, j) and the id of cell (i, j) as told.
  void relief(uint32_t columns, uint32_t rows,
              const std::function<Vec3(uint32_t, uint32_t)>& corner,
              const std::function<uint32_t(uint32_t, uint32_t)>& cell_id);
  /// A ball of loose triangular leaves: light gets through, in part.
  void crown(const Vec3& centre, double radius_m, int leaves, double leaf_m, RandomStream random);

  Model take() { return std::move(model_); }

 private:
  uint32_t vertex(const Vec3& p);
  void triangle(const Vec3& a, const Vec3& b, const Vec3& c, uint32_t id);
  uint32_t record(uint32_t part, const Frame& frame, const std::vector<Outline>& rings,
                  double area_m2, uint32_t id);
  void arched_joinery(uint32_t part, const Frame& back, const Rect& opening, double rise_m);
  void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t id);
  void grid(int nu, int nv, uint32_t id, auto&& point);

  Transform T_world_scene_;
  Model model_;
  uint32_t next_id_ = 1;
};

}  // namespace jalon
