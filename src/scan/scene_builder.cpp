// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jalon {

namespace {

constexpr double kJoineryWidth_m = 0.08;  // of a window frame (facade-segmentation, S2)

/// The lines on which a rectangle with rectangular openings is cut, and which cells belong to it.
struct Cells {
  std::vector<double> u, v;
  std::vector<char> inside;  ///< (u.size() - 1) * (v.size() - 1), row by row of v

  size_t columns() const { return u.size() - 1; }
  size_t rows() const { return v.size() - 1; }
  bool has(ptrdiff_t i, ptrdiff_t j) const {
    return i >= 0 && j >= 0 && i < static_cast<ptrdiff_t>(columns()) && j < static_cast<ptrdiff_t>(rows()) &&
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
        return cells.u[i] >= o.u0 && cells.u[i + 1] <= o.u1 && cells.v[j] >= o.v0 && cells.v[j + 1] <= o.v1;
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
std::vector<std::vector<Vec2>> rings_of(const Cells& cells) {
  const auto columns = static_cast<ptrdiff_t>(cells.u.size()), rows = static_cast<ptrdiff_t>(cells.v.size());
  std::vector<char> used(static_cast<size_t>(columns * rows * 4), 0);
  const auto mark = [&](ptrdiff_t i, ptrdiff_t j, int d) -> char& {
    return used[static_cast<size_t>((j * columns + i) * 4 + d)];
  };
  std::vector<std::vector<Vec2>> rings;
  for (ptrdiff_t j = 0; j < rows; ++j)
    for (ptrdiff_t i = 0; i < columns; ++i) {
      // Every ring has a corner where it turns from -v to +u, or, around an opening, from -v into +u at its top
      // right.
      if (!is_border(cells, i, j, 0) || mark(i, j, 0)) continue;
      std::vector<Vec2> ring;
      ptrdiff_t x = i, y = j;
      int d = 0;
      do {
        mark(x, y, d) = 1;
        x += d == 0 ? 1 : d == 2 ? -1 : 0;
        y += d == 1 ? 1 : d == 3 ? -1 : 0;
        // Left turns first: pieces that touch in a corner only stay apart.
        int next = (d + 1) % 4;
        if (!is_border(cells, x, y, next)) next = is_border(cells, x, y, d) ? d : (d + 3) % 4;
        if (next != d) ring.push_back({cells.u[static_cast<size_t>(x)], cells.v[static_cast<size_t>(y)]});
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

uint32_t SceneBuilder::face(uint32_t part, const Frame& frame, const Rect& outline, std::span<const Rect> openings,
                            uint32_t id) {
  if (id == 0) id = new_id();
  const Cells cells = cells_of(outline, openings);

  // 1. The true plane, the rings and the area.
  Face face;
  face.part = part;
  face.id = id;
  face.plane.normal = normalized(T_world_scene_.direction(frame.normal()));
  face.plane.offset = dot(face.plane.normal, T_world_scene_.point(frame.point(outline.u0, outline.v0)));
  std::vector<std::vector<Vec3>> rings;
  for (const auto& ring : rings_of(cells)) {
    rings.emplace_back();
    for (const Vec2& c : ring) rings.back().push_back(T_world_scene_.point(frame.point(c.u, c.v)));
  }
  for (size_t j = 0; j < cells.rows(); ++j)
    for (size_t i = 0; i < cells.columns(); ++i)
      if (cells.inside[j * cells.columns() + i] != 0)
        face.area_m2 += (cells.u[i + 1] - cells.u[i]) * (cells.v[j + 1] - cells.v[j]);
  model_.add_face(face, rings);

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

void SceneBuilder::recess(uint32_t part, const Frame& frame, const Rect& opening, double depth_m, bool has_sill,
                          double frame_m, uint32_t pane_id) {
  const Vec3 n = frame.normal();
  const Vec3 corner = frame.point(opening.u0, opening.v0, -depth_m);
  const double width = opening.width(), height = opening.height();
  const uint32_t pane = this->part("pane", "pane", part);
  const Frame back = frame.raised(-depth_m);
  if (frame_m > 0 && width > 3 * kJoineryWidth_m && height > 3 * kJoineryWidth_m) {
    const Rect glass{opening.u0 + kJoineryWidth_m, opening.u1 - kJoineryWidth_m, opening.v0 + kJoineryWidth_m,
                     opening.v1 - kJoineryWidth_m};
    face(this->part("joinery", "joinery", part), back, opening, {&glass, 1});
    face(pane, back.raised(-frame_m), glass, {}, pane_id);
  } else {
    face(pane, back, opening, {}, pane_id);
  }
  if (!(depth_m > 0)) return;
  const uint32_t reveals = this->part("reveals", "reveal", part);
  face(reveals, {corner, frame.v, n}, {0, height, 0, depth_m});                    // left, looks along +u
  face(reveals, {corner + frame.u * width, n, frame.v}, {0, depth_m, 0, height});  // right
  face(reveals, {corner + frame.v * height, frame.u, n}, {0, width, 0, depth_m});  // lintel
  if (has_sill) face(reveals, {corner, n, frame.u}, {0, depth_m, 0, width});
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

void SceneBuilder::grid(int nu, int nv, uint32_t id, auto&& point) {
  const auto first = static_cast<uint32_t>(model_.vertices.size()), width = static_cast<uint32_t>(nu);
  for (int j = 0; j <= nv; ++j)
    for (int i = 0; i < nu; ++i) vertex(point(2 * std::numbers::pi * i / nu, static_cast<double>(j) / nv));
  for (uint32_t j = 0; j < static_cast<uint32_t>(nv); ++j)
    for (uint32_t i = 0; i < width; ++i) {
      const uint32_t a = first + j * width + i, b = first + j * width + (i + 1) % width;
      quad(a, b, b + width, a + width, id);
    }
}

void SceneBuilder::cylinder(const Vec3& foot, double radius_m, double height_m, int facets) {
  grid(facets, 1, new_id(), [&](double angle, double part) {
    return foot + Vec3{radius_m * std::cos(angle), radius_m * std::sin(angle), part * height_m};
  });
}

void SceneBuilder::sphere(const Vec3& centre, double radius_m, int facets) {
  grid(facets, facets / 2, new_id(), [&](double angle, double part) {
    const double latitude = std::numbers::pi * (part - 0.5), r = radius_m * std::cos(latitude);
    return centre + Vec3{r * std::cos(angle), r * std::sin(angle), radius_m * std::sin(latitude)};
  });
}

}  // namespace jalon
