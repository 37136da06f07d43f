// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/builder/builder.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

/// The lines on which a rectangle with rectangular openings is cut, and which cells belong to it.
struct Cells {
  std::vector<double> u, v;
  std::vector<char> inside;  ///< (u.size() - 1) * (v.size() - 1), row by row of v

  size_t columns() const { return u.size() - 1; }
  size_t rows() const { return v.size() - 1; }
  bool has(ptrdiff_t i, ptrdiff_t j) const {
    return i >= 0 && j >= 0 && i < static_cast<ptrdiff_t>(columns()) &&
           j < static_cast<ptrdiff_t>(rows()) &&
           inside[static_cast<size_t>(j) * columns() + static_cast<size_t>(i)] != 0;
  }
};

std::vector<double> cuts(double from, double to, std::vector<double> lines) {
  lines.push_back(from);
  lines.push_back(to);
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  std::erase_if(lines, [&](double x) { return x < from || x > to; });
  return lines;
}

Cells cells_of(const Rect& outline, std::span<const Rect> openings) {
  std::vector<double> u, v;
  for (const Rect& o : openings) {
    u.insert(u.end(), {o.u0, o.u1});
    v.insert(v.end(), {o.v0, o.v1});
  }
  Cells cells{cuts(outline.u0, outline.u1, u), cuts(outline.v0, outline.v1, v), {}};
  for (size_t j = 0; j < cells.rows(); ++j)
    for (size_t i = 0; i < cells.columns(); ++i) {
      const bool open = std::any_of(openings.begin(), openings.end(), [&](const Rect& o) {
        return cells.u[i] >= o.u0 && cells.u[i + 1] <= o.u1 && cells.v[j] >= o.v0 &&
               cells.v[j + 1] <= o.v1;
      });
      cells.inside.push_back(open ? 0 : 1);
    }
  return cells;
}

/// A directed border edge of the cells starts at grid corner (i, j) and goes in direction d = 0 ... 3: +u, +v, -u,
/// -v, the inside at its left.
bool is_border(const Cells& cells, ptrdiff_t i, ptrdiff_t j, int d) {
  switch (d) {
    case 0:
      return cells.has(i, j) && !cells.has(i, j - 1);
    case 1:
      return cells.has(i - 1, j) && !cells.has(i, j);
    case 2:
      return cells.has(i - 1, j - 1) && !cells.has(i - 1, j);
    default:
      return cells.has(i, j - 1) && !cells.has(i - 1, j - 1);
  }
}

/// Rings around the inside cells, corners only: counter-clockwise outside, clockwise around openings. The ring that
/// starts at the lowest border edge comes first; of a connected piece that is the outline.
std::vector<Outline> rings_of(const Cells& cells) {
  const auto columns = static_cast<ptrdiff_t>(cells.u.size()),
             rows = static_cast<ptrdiff_t>(cells.v.size());
  std::vector<char> used(static_cast<size_t>(columns * rows * 4), 0);
  const auto mark = [&](ptrdiff_t i, ptrdiff_t j, int d) -> char& {
    return used[static_cast<size_t>((j * columns + i) * 4 + d)];
  };
  std::vector<Outline> rings;
  for (ptrdiff_t j = 0; j < rows; ++j)
    for (ptrdiff_t i = 0; i < columns; ++i) {
      // Every ring has a corner where it turns from -v to +u, or, around an opening, from -v into +u at its top
      // right.
      if (!is_border(cells, i, j, 0) || mark(i, j, 0)) continue;
      Outline ring;
      ptrdiff_t x = i, y = j;
      int d = 0;
      do {
        mark(x, y, d) = 1;
        x += d == 0 ? 1 : d == 2 ? -1 : 0;
        y += d == 1 ? 1 : d == 3 ? -1 : 0;
        // Left turns first: pieces that touch in a corner only stay apart.
        int next = (d + 1) % 4;
        if (!is_border(cells, x, y, next)) next = is_border(cells, x, y, d) ? d : (d + 3) % 4;
        if (next != d)
          ring.push_back({cells.u[static_cast<size_t>(x)], cells.v[static_cast<size_t>(y)]});
        d = next;
      } while (!(x == i && y == j && d == 0));
      rings.push_back(std::move(ring));
    }
  return rings;
}

}  // namespace

uint32_t SceneBuilder::part(std::string name, std::string part_class, uint64_t parent) {
  model_.parts.push_back({std::move(name), std::move(part_class), parent});
  return static_cast<uint32_t>(model_.parts.size() - 1);
}

uint32_t SceneBuilder::vertex(const Vec3& p) {
  model_.vertices.push_back(T_world_scene_.point(p));
  return static_cast<uint32_t>(model_.vertices.size() - 1);
}

void SceneBuilder::quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t id) {
  model_.triangles.push_back({a, b, c});
  model_.triangles.push_back({a, c, d});
  model_.triangle_faces.insert(model_.triangle_faces.end(), 2, id);
}

uint32_t SceneBuilder::record(uint32_t part, const Frame& frame, const std::vector<Outline>& rings,
                              double area_m2, uint32_t id) {
  Face face;
  face.part = part;
  face.id = id == 0 ? new_id() : id;
  face.area_m2 = area_m2;
  face.plane.normal = normalized(T_world_scene_.direction(frame.normal()));
  face.plane.offset = dot(face.plane.normal, T_world_scene_.point(frame.origin));
  std::vector<std::vector<Vec3>> corners;
  for (const Outline& ring : rings) {
    corners.emplace_back();
    for (const Vec2& c : ring)
      corners.back().push_back(T_world_scene_.point(frame.point(c.u, c.v)));
  }
  model_.add_face(face, corners);
  return face.id;
}

uint32_t SceneBuilder::face(uint32_t part, const Frame& frame, const Rect& outline,
                            std::span<const Rect> openings, uint32_t id) {
  const Cells cells = cells_of(outline, openings);

  // 1. The true plane, the rings and the area.
  double area_m2 = 0;
  for (size_t j = 0; j < cells.rows(); ++j)
    for (size_t i = 0; i < cells.columns(); ++i)
      if (cells.inside[j * cells.columns() + i] != 0)
        area_m2 += (cells.u[i + 1] - cells.u[i]) * (cells.v[j + 1] - cells.v[j]);
  id = record(part, frame, rings_of(cells), area_m2, id);

  // 2. Two triangles a cell, on common vertices.
  const auto first = static_cast<uint32_t>(model_.vertices.size());
  for (const double t : cells.v)
    for (const double s : cells.u) vertex(frame.point(s, t));
  const auto width = static_cast<uint32_t>(cells.u.size());
  for (uint32_t j = 0; j < cells.rows(); ++j)
    for (uint32_t i = 0; i < cells.columns(); ++i) {
      if (cells.inside[j * cells.columns() + i] == 0) continue;
      const uint32_t a = first + j * width + i;
      quad(a, a + 1, a + 1 + width, a + width, id);
    }
  return id;
}

void SceneBuilder::box(uint32_t part, const Vec3& corner, const Vec3& size, bool has_bottom) {
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  face(part, {corner + z * size.z, x, y}, {0, size.x, 0, size.y});
  face(part, {corner, x, z}, {0, size.x, 0, size.z});
  face(part, {corner + y * size.y, z, x}, {0, size.z, 0, size.x});
  face(part, {corner, z, y}, {0, size.z, 0, size.y});
  face(part, {corner + x * size.x, y, z}, {0, size.y, 0, size.z});
  if (has_bottom) face(part, {corner, y, x}, {0, size.y, 0, size.x});
}

}  // namespace jalon
