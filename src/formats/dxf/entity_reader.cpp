// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Autodesk, "DXF Reference", section ENTITIES: those that bound surfaces.
#include <cmath>
#include <numbers>
#include <utility>

#include "base/text_number.h"
#include "formats/dxf/sections.h"
#include "formats/dxf/shapes.h"
#include "formats/files/utf8.h"

namespace jalon::dxf {

namespace {

// Group 70 of POLYLINE and of VERTEX.
enum : int64_t { kClosedRing = 1, kIn3d = 8, kGrid = 16, kClosedAcross = 32, kPolyface = 64 };
enum : int64_t { kSplineFrame = 16, kOfPolyface = 128, kHasPlace = 64 };

/// The groups of one entity that several kinds have.
struct Common {
  std::string layer = "0";
  Vec3 places[4];  ///< groups 10 ... 13
  Vec3 normal{0, 0, 1};
  bool has_fourth = false;

  // True when it was one of them.
  bool take(GroupReader& groups) {
    const int code = groups.code();
    if (code == 8) layer = name_from_file(groups.text(), "0");
    else if (code >= 10 && code <= 39 && code % 10 <= 3 && code / 10 <= 3)
      places[code % 10][code / 10 - 1] = groups.number(), has_fourth |= code % 10 == 3;
    else if (code == 210 || code == 220 || code == 230) normal[(code - 210) / 10] = groups.number();
    else return false;
    return true;
  }
  Vec3 unit_normal() const { return norm(normal) > 0 ? normalized(normal) : Vec3{0, 0, 1}; }
};

// From object coordinates into space.
Vec3 in_space(const Vec3& p, const Vec3& normal) {
  const ObjectAxes axes = object_axes(normal);
  return axes.x * p.x + axes.y * p.y + axes.z * p.z;
}

// Of our own files: "face=7", "class=window" ... behind 1001 JALON.
class ToldReader {
 public:
  void take(const GroupReader& groups) {
    if (groups.code() == 1001) is_ours_ = groups.value() == "JALON";
    if (groups.code() != 1000 || !is_ours_) return;
    const std::string text = groups.text();
    const size_t equals = text.find('=');
    if (equals == std::string::npos) return;
    const std::string_view name = std::string_view(text).substr(0, equals);
    const std::string value = text.substr(equals + 1);
    Part& part = told_.part;
    int64_t number = 0;
    if (name == "face" && parse_integer(value, number) && number >= 0 && number < UINT32_MAX)
      told_.is_ours = true, told_.face = static_cast<uint32_t>(number);
    else if (name == "number" && parse_integer(value, number)) told_.number = number;
    else if (name == "part") part.name = name_from_file(value, "part");
    else if (name == "class") part.part_class = value;
    else if (name == "evidence") part.evidence = evidence_named(value);
    else if (name == "depth_m") read(value, part.depth_m);
    else if (name == "class_confidence") read(value, part.class_confidence);
  }
  Told take_all() { return std::exchange(told_, {}); }

 private:
  static void read(const std::string& text, double& out) {
    double value = 0;
    if (parse_number(text, value) && std::isfinite(value)) out = value;
  }
  bool is_ours_ = false;
  Told told_;
};

// Calls take for each group of the entity.
template <class Take>
void for_groups(GroupReader& groups, Take&& take) {
  while (groups.next()) {
    if (groups.code() == 0) {
      groups.put_back();
      return;
    }
    take();
  }
}

// A last corner that is the first one again, as drawings by hand have.
void close(Loop& loop, bool is_closed, Shapes& shapes, const char* name) {
  const bool repeats = loop.corners.size() > 1 && loop.corners.front() == loop.corners.back();
  if (repeats) loop.corners.pop_back(), loop.bulges.pop_back();
  if (is_closed || repeats) shapes.loops.push_back(std::move(loop));
  else ++shapes.left_out[std::string("open ") + name];
}

void read_lightweight(GroupReader& groups, Shapes& shapes) {
  Common common;
  Loop loop;
  ToldReader told;
  double elevation = 0;
  int64_t flags = 0;
  for_groups(groups, [&] {
    switch (groups.code()) {
      case 10:
        loop.corners.push_back({groups.number(), 0, 0}), loop.bulges.push_back(0);
        break;
      case 20:
        if (loop.corners.empty()) groups.refuse("a corner without x");
        loop.corners.back().y = groups.number();
        break;
      case 42:
        if (!loop.bulges.empty()) loop.bulges.back() = groups.number();
        break;
      case 38:
        elevation = groups.number();
        break;
      case 70:
        flags = groups.integer();
        break;
      default:
        if (!common.take(groups)) told.take(groups);
    }
  });
  loop.layer = common.layer;
  loop.normal = common.unit_normal();
  for (Vec3& p : loop.corners) p = in_space({p.x, p.y, elevation}, loop.normal);
  loop.told = told.take_all();
  close(loop, (flags & kClosedRing) != 0, shapes, "LWPOLYLINE");
}

/// A vertex of POLYLINE.
struct Vertex {
  Vec3 at;
  double bulge = 0;
  int64_t flags = 0;
  std::vector<int64_t> corners;  ///< of a polyface's face: groups 71 ... 74
};

Vertex read_vertex(GroupReader& groups) {
  Common common;
  Vertex out;
  for_groups(groups, [&] {
    const int code = groups.code();
    if (code == 42) out.bulge = groups.number();
    else if (code == 70) out.flags = groups.integer();
    else if (code >= 71 && code <= 74) out.corners.push_back(groups.integer());
    else common.take(groups);
  });
  out.at = common.places[0];
  return out;
}

void add_grid(const std::vector<Vertex>& vertices, int64_t flags, int64_t m, int64_t n,
              GroupReader& groups, Patch& patch) {
  if (m < 2 || n < 2 || m > INT16_MAX || n > INT16_MAX ||
      static_cast<size_t>(m * n) != vertices.size())
    groups.refuse("a mesh of %lld x %lld corners has %zu", static_cast<long long>(m),
                  static_cast<long long>(n), vertices.size());
  for (const Vertex& v : vertices) patch.corners.push_back(v.at);
  const auto at = [&](int64_t i, int64_t j) { return static_cast<uint32_t>((i % m) * n + j % n); };
  for (int64_t i = 0; i < m - ((flags & kClosedRing) != 0 ? 0 : 1); ++i)
    for (int64_t j = 0; j < n - ((flags & kClosedAcross) != 0 ? 0 : 1); ++j)
      patch.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
}

void add_polyface(const std::vector<Vertex>& vertices, const GroupReader& groups, Patch& patch) {
  for (const Vertex& v : vertices)
    if ((v.flags & kHasPlace) != 0) patch.corners.push_back(v.at);
  for (const Vertex& v : vertices) {
    if ((v.flags & kHasPlace) != 0 || (v.flags & kOfPolyface) == 0) continue;
    std::vector<uint32_t> polygon;
    for (const int64_t corner : v.corners) {
      if (corner == 0) continue;               // a triangle has no fourth
      const int64_t index = std::abs(corner);  // negative: an edge that is not drawn
      if (index > static_cast<int64_t>(patch.corners.size()))
        groups.refuse("a face names corner %lld of %zu", static_cast<long long>(index),
                      patch.corners.size());
      polygon.push_back(static_cast<uint32_t>(index - 1));
    }
    if (polygon.size() >= 3) patch.polygons.push_back(std::move(polygon));
  }
}

void read_polyline(GroupReader& groups, Shapes& shapes) {
  Common common;
  ToldReader told;
  int64_t flags = 0, m = 0, n = 0;
  for_groups(groups, [&] {
    if (groups.code() == 70) flags = groups.integer();
    else if (groups.code() == 71) m = groups.integer();
    else if (groups.code() == 72) n = groups.integer();
    else if (!common.take(groups)) told.take(groups);
  });
  std::vector<Vertex> vertices;
  bool has_end = false;
  while (groups.next()) {
    if (groups.is(0, "VERTEX")) {
      Vertex v = read_vertex(groups);
      if ((v.flags & kSplineFrame) == 0) vertices.push_back(std::move(v));
      continue;
    }
    has_end = groups.is(0, "SEQEND");
    if (has_end) for_groups(groups, [] {});
    else groups.put_back();
    break;
  }
  if (!has_end) groups.refuse("a POLYLINE has no SEQEND");
  if ((flags & (kGrid | kPolyface)) != 0) {
    Patch patch;
    patch.layer = common.layer;
    if ((flags & kGrid) != 0) add_grid(vertices, flags, m, n, groups, patch);
    else add_polyface(vertices, groups, patch);
    shapes.patches.push_back(std::move(patch));
    return;
  }
  Loop loop;
  loop.layer = common.layer;
  const bool is_flat = (flags & kIn3d) == 0;
  loop.normal = is_flat ? common.unit_normal() : Vec3{};
  for (const Vertex& v : vertices) {
    loop.corners.push_back(is_flat ? in_space({v.at.x, v.at.y, common.places[0].z}, loop.normal)
                                   : v.at);
    loop.bulges.push_back(is_flat ? v.bulge : 0);
  }
  loop.told = told.take_all();
  close(loop, (flags & kClosedRing) != 0, shapes, "POLYLINE");
}

void read_face(GroupReader& groups, Shapes& shapes, bool in_object_coordinates) {
  Common common;
  for_groups(groups, [&] { common.take(groups); });
  Patch patch;
  patch.layer = common.layer;
  const auto& p = common.places;
  if (in_object_coordinates) {  // SOLID: the last two corners are written crosswise
    const Vec3 normal = common.unit_normal();
    for (const int k : {0, 1, 3, 2}) patch.corners.push_back(in_space(p[k], normal));
  } else {
    patch.corners = {p[0], p[1], p[2], p[3]};
  }
  if (!common.has_fourth)
    patch.corners = {patch.corners[0], patch.corners[1],
                     in_object_coordinates ? patch.corners[3] : patch.corners[2]};
  std::vector<uint32_t> polygon;
  for (uint32_t k = 0; k < patch.corners.size(); ++k)
    if (k == 0 ||
        (patch.corners[k] != patch.corners[k - 1] && patch.corners[k] != patch.corners[0]))
      polygon.push_back(k);
  if (polygon.size() < 3) return;  // a line or a point
  patch.polygons = {std::move(polygon)};
  shapes.patches.push_back(std::move(patch));
}

void read_circle(GroupReader& groups, Shapes& shapes) {
  Common common;
  double radius = 0;
  for_groups(groups, [&] {
    if (groups.code() == 40) radius = groups.number();
    else common.take(groups);
  });
  if (!(radius > 0)) return;
  Loop loop;
  loop.layer = common.layer;
  loop.normal = common.unit_normal();
  const Vec3 c = common.places[0];
  loop.corners = {in_space({c.x - radius, c.y, c.z}, loop.normal),
                  in_space({c.x + radius, c.y, c.z}, loop.normal)};
  loop.bulges = {1, 1};
  shapes.loops.push_back(std::move(loop));
}

// MESH: its control polygons, not those that a level of subdivision would make of them.
void read_mesh(GroupReader& groups, Shapes& shapes) {
  Common common;
  Patch patch;
  bool in_corners = false, in_faces = false;
  size_t left = 0;
  for_groups(groups, [&] {
    const int code = groups.code();
    if (code == 92) in_corners = true;
    else if (code == 93) in_corners = false, in_faces = true;
    else if (code == 94 || code == 95) in_faces = false;
    else if (in_corners && code == 10) patch.corners.push_back({groups.number(), 0, 0});
    else if (in_corners && (code == 20 || code == 30) && !patch.corners.empty())
      patch.corners.back()[code / 10 - 1] = groups.number();
    else if (in_faces && code == 90) {
      const int64_t value = groups.integer();
      if (left == 0) {
        if (value < 3 || value > static_cast<int64_t>(patch.corners.size()))
          groups.refuse("a face of a mesh with %lld corners", static_cast<long long>(value));
        left = static_cast<size_t>(value);
        patch.polygons.emplace_back();
      } else {
        if (value < 0 || value >= static_cast<int64_t>(patch.corners.size()))
          groups.refuse("a face names corner %lld of %zu", static_cast<long long>(value),
                        patch.corners.size());
        patch.polygons.back().push_back(static_cast<uint32_t>(value));
        --left;
      }
    } else common.take(groups);
  });
  if (left != 0) groups.refuse("the last face of a mesh is not whole");
  patch.layer = common.layer;
  if (!patch.polygons.empty()) shapes.patches.push_back(std::move(patch));
}

void read_insert(GroupReader& groups, Shapes& shapes) {
  Common common;
  Insert insert;
  for_groups(groups, [&] {
    const int code = groups.code();
    if (code == 2) insert.block = groups.text();
    else if (code >= 41 && code <= 43) insert.scale[code - 41] = groups.number();
    else if (code == 44) insert.column_step = groups.number();
    else if (code == 45) insert.row_step = groups.number();
    else if (code == 50) insert.rotation_rad = groups.number() * std::numbers::pi / 180;
    else if (code == 70) insert.columns = groups.integer();
    else if (code == 71) insert.rows = groups.integer();
    else common.take(groups);
  });
  insert.layer = common.layer;
  insert.at = common.places[0];
  insert.normal = common.unit_normal();
  shapes.inserts.push_back(std::move(insert));
}

}  // namespace

void read_entity(GroupReader& groups, Shapes& shapes) {
  const std::string name(groups.value());
  if (name == "LWPOLYLINE") return read_lightweight(groups, shapes);
  if (name == "POLYLINE") return read_polyline(groups, shapes);
  if (name == "3DFACE") return read_face(groups, shapes, false);
  if (name == "SOLID" || name == "TRACE") return read_face(groups, shapes, true);
  if (name == "CIRCLE") return read_circle(groups, shapes);
  if (name == "MESH") return read_mesh(groups, shapes);
  if (name == "INSERT") return read_insert(groups, shapes);
  // What belongs to another entity (ATTRIB, SEQEND of an INSERT) and labels are no surfaces that anybody misses.
  if (name != "ATTRIB" && name != "SEQEND" && name != "TEXT" && name != "MTEXT")
    ++shapes.left_out[name_from_file(name, "?")];
  for_groups(groups, [] {});
}

}  // namespace jalon::dxf
