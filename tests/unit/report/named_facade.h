// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "model/part_classes.h"

/// A facade with named openings as a modeller makes it, built by hand: walls in the plane y = 0 seen from -Y, doors as
/// notches of the wall, windows with arched or straight heads 0.15 m deep, a cornice 0.3 m in front, the ground.
namespace named_facade {

using namespace jalon;

struct Setting {
  size_t columns = 5, rows = 3;
  double window_width = 1.2, window_height = 1.5, pitch = 3, storey = 3.2;
  bool arched_top_row = true;
  bool door = true;
  size_t copied = ~size_t{0}, empty = ~size_t{0};  ///< windows, counted from the lowest left
  bool no_data = true;
  double corner_variance = 0;  ///< m2, of each coordinate of each vertex; 0: not known
  Vec3 shift;
};

/// A vertical or level face from rings of points; sagittas one a corner of all rings, or empty.
inline void add(Model& m, uint32_t part, const Plane& plane,
                const std::vector<std::vector<Vec3>>& rings, const std::vector<double>& sagittas,
                double area, uint32_t id) {
  if (m.sagittas.size() < m.corners.size()) m.sagittas.resize(m.corners.size(), 0);
  Face face;
  face.part = part;
  face.id = id;
  face.plane = plane;
  face.area_m2 = area;
  face.sigma_m = 0.004;
  for (size_t k : {0u, 5u, 10u}) face.covariance[k] = 1e-10;
  face.covariance[15] = 1e-6;
  const size_t first = m.corners.size();
  m.add_face(face, rings);
  m.sagittas.resize(m.corners.size(), 0);
  for (size_t i = 0; i < sagittas.size(); ++i) m.sagittas[first + i] = sagittas[i];
}

inline Part part(const std::string& name, const char* part_class, uint64_t parent,
                 Evidence evidence = Evidence::kMeasured) {
  Part p;
  p.name = name;
  p.part_class = part_class;
  p.parent = parent;
  p.evidence = evidence;
  return p;
}

/// Clockwise seen from the street, as holes run; the head is an arc when the sagitta is not 0.
inline std::vector<Vec2> hole(double x, double z, double width, double height) {
  return {{x, z}, {x, z + height}, {x + width, z + height}, {x + width, z}};
}

inline std::vector<Vec3> lifted(const std::vector<Vec2>& ring, double y, bool reversed = false) {
  std::vector<Vec3> out;
  for (const Vec2& p : ring) out.push_back({p.u, y, p.v});
  if (reversed) out = {out[0], out[3], out[2], out[1]};
  return out;
}

inline Model make(const Setting& s) {
  Model m;
  const double width = s.pitch * static_cast<double>(s.columns),
               height = s.storey * static_cast<double>(s.rows) + 1;
  const Plane front{{0, -1, 0}, 0}, behind{{0, -1, 0}, -0.15}, before{{0, -1, 0}, 0.3};
  m.parts = {part("facade 1", part_class::kFacade, kNoParent), part("wall 1", part_class::kWall, 0),
             part("cornice 1", part_class::kCornice, 0),
             part("ground 1", part_class::kGround, kNoParent)};
  std::vector<std::vector<Vec3>> rings(1);
  std::vector<double> sagittas;
  std::vector<uint32_t> fillers{kNoPart};
  const double door_x = s.pitch / 2 - 0.55;
  rings[0] = s.door
                 ? std::vector<Vec3>{{0, 0, 0},
                                     {door_x, 0, 0},
                                     {door_x, 0, 2.3},
                                     {door_x + 1.0, 0, 2.3},
                                     {door_x + 1.0, 0, 0},
                                     {width, 0, 0},
                                     {width, 0, height},
                                     {0, 0, height}}
                 : std::vector<Vec3>{{0, 0, 0}, {width, 0, 0}, {width, 0, height}, {0, 0, height}};
  sagittas.assign(rings[0].size(), 0);
  const auto first_window = static_cast<uint32_t>(m.parts.size());
  for (size_t row = 0, window = 0; row < s.rows; ++row)
    for (size_t column = 0; column < s.columns; ++column) {
      if (s.door && row == 0 && column == 0) continue;
      const double x = s.pitch * (static_cast<double>(column) + 0.5) - s.window_width / 2;
      const double z = s.storey * static_cast<double>(row) + 0.9;
      const bool is_arched = s.arched_top_row && row + 1 == s.rows;
      rings.push_back(lifted(hole(x, z, s.window_width, s.window_height), 0));
      // The arc of a hole runs from its left spring to its right one: clockwise seen against the normal.
      for (const double sagitta : {0.0, is_arched ? -s.window_width / 2 : 0.0, 0.0, 0.0})
        sagittas.push_back(sagitta);
      fillers.push_back(static_cast<uint32_t>(m.parts.size()));
      const Evidence evidence = window == s.copied  ? Evidence::kCopied
                                : window == s.empty ? Evidence::kShape
                                                    : Evidence::kSeenBehind;
      Part p = part("window " + std::to_string(window + 1), part_class::kWindow, 1, evidence);
      p.width_m = s.window_width;
      p.height_m = s.window_height + (is_arched ? s.window_width / 2 : 0);
      p.depth_m = 0.15;
      if (window++ == s.copied) p.copied_from = first_window;
      m.parts.push_back(p);
    }
  add(m, 1, front, rings, sagittas, width * height - 3.0 * static_cast<double>(rings.size()), 1);
  for (size_t r = 0; r < rings.size(); ++r) m.rings[r].part = fillers[r];
  for (size_t r = 1; r < rings.size(); ++r) {
    const uint32_t opening = fillers[r];
    if (opening - first_window == s.empty) continue;
    const auto joinery = static_cast<uint32_t>(m.parts.size());
    m.parts.push_back(part("pane " + std::to_string(r), part_class::kJoinery, opening));
    m.parts.push_back(
        part("reveal " + std::to_string(r), part_class::kReveal, opening, Evidence::kDerived));
    std::vector<Vec2> ring;
    for (const Vec3& p : rings[r]) ring.push_back({p.x, p.z});
    const double crown = -sagittas[rings[0].size() + 4 * (r - 1) + 1];
    add(m, joinery, behind, {lifted(ring, 0.15, true)}, {0, 0, crown, 0},
        s.window_width * s.window_height, 10);
    add(m, joinery + 1, {{1, 0, 0}, ring[0].u},
        {{{ring[0].u, 0, ring[0].v},
          {ring[0].u, 0.15, ring[0].v},
          {ring[0].u, 0.15, ring[1].v},
          {ring[0].u, 0, ring[1].v}}},
        {}, 0.15 * s.window_height, 0);
  }
  if (s.door) {
    Part p = part("door 1", part_class::kDoor, 1, Evidence::kRevealed);
    p.depth_m = 0.25;
    m.parts.push_back(p);
    add(m, static_cast<uint32_t>(m.parts.size() - 1), {{0, -1, 0}, -0.25},
        {lifted({{door_x, 0}, {door_x + 1.0, 0}, {door_x + 1.0, 2.3}, {door_x, 2.3}}, 0.25)}, {},
        2.3, 11);
  }
  add(m, 2, before,
      {lifted({{-0.2, height - 0.4},
               {width + 0.2, height - 0.4},
               {width + 0.2, height},
               {-0.2, height}},
              -0.3)},
      {}, 0.4 * width, 2);
  add(m, 3, {{0, 0, 1}, 0}, {{{-2, 0, 0}, {-2, -4, 0}, {width + 2, -4, 0}, {width + 2, 0, 0}}}, {},
      4 * width, 3);
  if (s.no_data) {
    m.parts.push_back(part("no data 1", part_class::kNoData, 1, Evidence::kNone));
    const double x = width - s.pitch / 2 + 0.75;
    add(m, static_cast<uint32_t>(m.parts.size() - 1), front,
        {lifted({{x, 0.1}, {x + 0.6, 0.3}, {x + 0.5, 1.9}, {x - 0.05, 1.6}}, 0)}, {}, 0.9, 0);
  }
  for (Vec3& p : m.vertices) p += s.shift;
  for (Face& face : m.faces) face.plane.offset += dot(face.plane.normal, s.shift);
  if (s.corner_variance > 0)
    m.vertex_covariances.assign(m.vertices.size(), {s.corner_variance, 0, 0, 0, s.corner_variance,
                                                    0, 0, 0, s.corner_variance});
  return m;
}

}  // namespace named_facade
