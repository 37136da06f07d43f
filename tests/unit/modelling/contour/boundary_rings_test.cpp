// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "geometry/polygon2.h"
#include "modelling/contour/boundary_rings.h"

using namespace jalon;

namespace {

// Two triangles a cell of a raster, where the mask has a '#'; point index = row * (columns + 1) + column.
struct Raster {
  std::vector<Vec2> points;
  std::vector<Triangle2> triangles;
};

Raster raster_of(const std::vector<const char*>& rows) {
  Raster out;
  const auto height = static_cast<uint32_t>(rows.size());
  uint32_t width = 0;
  while (rows[0][width] != 0) ++width;
  for (uint32_t v = 0; v <= height; ++v)
    for (uint32_t u = 0; u <= width; ++u)
      out.points.push_back({static_cast<double>(u), static_cast<double>(v)});
  for (uint32_t v = 0; v < height; ++v)
    for (uint32_t u = 0; u < width; ++u) {
      if (rows[v][u] != '#') continue;
      const uint32_t a = v * (width + 1) + u, b = a + 1, c = a + width + 1, d = c + 1;
      out.triangles.push_back({a, b, d});
      out.triangles.push_back({a, d, c});
    }
  return out;
}

struct Rings {
  size_t pieces = 0;
  std::vector<double> areas;  ///< signed, of all rings
};

Rings rings_of(const std::vector<const char*>& rows) {
  const Raster raster = raster_of(rows);
  Rings out;
  Task task;
  for (const auto& piece : boundary_rings(raster.triangles, raster.points, task)) {
    ++out.pieces;
    double sum = 0;
    for (const auto& ring : piece.rings) {
      std::vector<Vec2> polygon;
      for (const uint32_t i : ring) polygon.push_back(raster.points[i]);
      out.areas.push_back(signed_area(polygon));
      sum += out.areas.back();
      std::vector<uint32_t> sorted(ring);
      std::sort(sorted.begin(), sorted.end());
      CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
    }
    CHECK(sum == doctest::Approx(piece.area));
  }
  std::sort(out.areas.begin(), out.areas.end());
  return out;
}

}  // namespace

TEST_CASE("boundary_rings: a block has one anticlockwise ring, its hole a clockwise one") {
  const Rings rings = rings_of({"####", "#..#", "####"});
  CHECK(rings.pieces == 1);
  CHECK(rings.areas == std::vector<double>{-2, 12});
}

TEST_CASE("boundary_rings: pieces that touch in a point stay apart") {
  const Rings rings = rings_of({"##..", "##..", "..##", "..##"});
  CHECK(rings.pieces == 2);
  CHECK(rings.areas == std::vector<double>{4, 4});
}

TEST_CASE("boundary_rings: a hole that touches the outside in a point is still a hole") {
  // Row 0 is the lowest; the hole at (1, 1) meets the outer corner notch at (2, 2).
  const Rings rings = rings_of({"####", "#.##", "##..", "##.."});
  CHECK(rings.pieces == 1);
  CHECK(rings.areas == std::vector<double>{-1, 12});
}

TEST_CASE("boundary_rings: two holes that touch in a point are two rings") {
  const Rings rings = rings_of({"####", "#.##", "##.#", "####"});
  CHECK(rings.pieces == 1);
  CHECK(rings.areas == std::vector<double>{-1, -1, 16});
}

TEST_CASE("boundary_rings: an island in a hole is a piece of its own") {
  const Rings rings = rings_of({"#####", "#...#", "#.#.#", "#...#", "#####"});
  CHECK(rings.pieces == 2);
  CHECK(rings.areas == std::vector<double>{-9, 1, 25});
}

TEST_CASE("boundary_rings: no triangles, no rings") {
  Task task;
  CHECK(boundary_rings({}, {}, task).empty());
}
