// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/geopackage/geometry.h"

#include <span>

#include "formats/files/endian.h"

namespace jalon::gpkg {

namespace {

enum WkbType : uint32_t { kLineStringZ = 1002, kPolygonZ = 1003, kMultiPolygonZ = 1006 };

void append_point(std::string& out, const Vec3& p) {
  for (int i = 0; i < 3; ++i) append_stored(out, p[i]);
}

void append_type(std::string& out, WkbType type) {
  constexpr char kLittleEndian = 1;
  out += kLittleEndian;
  append_stored(out, static_cast<uint32_t>(type));
}

void append_polygon(std::string& out, const Polygon& polygon) {
  append_type(out, kPolygonZ);
  append_stored(out, static_cast<uint32_t>(polygon.size()));
  for (const Line& ring : polygon) {
    append_stored(out, static_cast<uint32_t>(ring.size() + 1));
    for (const Vec3& p : ring) append_point(out, p);
    append_point(out, ring.front());
  }
}

std::string header(const Box3& box, int32_t srs_id) {
  constexpr char kVersion1 = 0, kLittleEndian = 1, kBoxOfXY = 1 << 1;
  std::string out = "GP";
  out += {kVersion1, kLittleEndian | kBoxOfXY};
  append_stored(out, srs_id);
  for (const double side : {box.min.x, box.max.x, box.min.y, box.max.y}) append_stored(out, side);
  return out;
}

void add_outline(Box3& box, const Polygon& polygon) {
  for (const Vec3& p : polygon.front()) box.add(p);
}

}  // namespace

std::string line_bytes(const Line& line, int32_t srs_id) {
  Box3 box;
  for (const Vec3& p : line) box.add(p);
  std::string out = header(box, srs_id);
  append_type(out, kLineStringZ);
  append_stored(out, static_cast<uint32_t>(line.size()));
  for (const Vec3& p : line) append_point(out, p);
  return out;
}

std::string polygon_bytes(const Polygon& polygon, int32_t srs_id) {
  Box3 box;
  add_outline(box, polygon);
  std::string out = header(box, srs_id);
  append_polygon(out, polygon);
  return out;
}

std::string polygons_bytes(const std::vector<Polygon>& polygons, int32_t srs_id) {
  Box3 box;
  for (const Polygon& polygon : polygons) add_outline(box, polygon);
  std::string out = header(box, srs_id);
  append_type(out, kMultiPolygonZ);
  append_stored(out, static_cast<uint32_t>(polygons.size()));
  for (const Polygon& polygon : polygons) append_polygon(out, polygon);
  return out;
}

}  // namespace jalon::gpkg
