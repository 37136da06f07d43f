// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Contour points by long edges and by alpha shape: hits of each at three jitters.
#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <string>

#include "base/random.h"
#include "modelling/contour/band.h"
#include "modelling/contour/contour.h"
#include "modelling/contour/long_edges.h"

using namespace jalon;

namespace {

constexpr double kContourModesSpacing = 0.10;
enum Place { kOuter, kHole, kInner };

/// A wall of 3.0 x 3.5 m, a point every 0.10 m, those in a window of 1.1 x 1.6 m removed.
struct GridWall {
  ContourBand band;
  std::vector<Place> places;

  explicit GridWall(double jitter_m) {
    RandomStream random(1, 11);
    for (int i = 0; i < 31; ++i)
      for (int j = 0; j < 36; ++j) {
        const bool in_window = i >= 10 && i < 21 && j >= 10 && j < 26;
        const double u = random.uniform() - 0.5, v = random.uniform() - 0.5;
        if (in_window) continue;
        band.points.push_back({kContourModesSpacing * i + 2 * jitter_m * u,
                               kContourModesSpacing * j + 2 * jitter_m * v});
        const bool is_outer = i == 0 || j == 0 || i == 30 || j == 35;
        const bool beside = i >= 9 && i < 22 && j >= 9 && j < 27;
        places.push_back(is_outer ? kOuter : beside ? kHole : kInner);
      }
    band.is_inner.assign(band.points.size(), 0);
    band.spacing_m.assign(band.points.size(), static_cast<float>(kContourModesSpacing));
  }
};

struct Hits {
  int outer = 0, hole = 0, inner = 0;
};

Hits hits(const GridWall& wall, const std::vector<uint32_t>& points) {
  Hits out;
  for (const uint32_t i : points) {
    int& count = wall.places[i] == kOuter  ? out.outer
                 : wall.places[i] == kHole ? out.hole
                                           : out.inner;
    ++count;
  }
  return out;
}

std::vector<uint32_t> on_rings(const GridWall& wall, const std::vector<Triangle2>& triangles) {
  std::set<uint32_t> out;
  Task task;
  for (const BoundaryPiece& piece : boundary_rings(triangles, wall.band.points, task))
    for (const auto& ring : piece.rings) out.insert(ring.begin(), ring.end());
  return {out.begin(), out.end()};
}

struct Row {
  const char* rule;
  double spacings;
  Hits expected[3];  ///< at jitter 0.1, 10 and 30 mm, one seed of those who counted first
};

constexpr double kJitters_m[] = {0.0001, 0.010, 0.030};
constexpr Row kTable[] = {
    {"long edges", 2, {{69, 50, 0}, {70, 47, 0}, {72, 38, 0}}},
    {"long edges", 3, {{48, 42, 0}, {49, 39, 0}, {48, 29, 0}}},
    {"long edges", 4, {{35, 38, 0}, {38, 35, 0}, {38, 25, 0}}},
    {"short triangles", 3, {{73, 46, 0}, {73, 43, 0}, {72, 35, 0}}},
    {"short triangles", 2, {{109, 54, 0}, {108, 52, 0}, {109, 49, 0}}},
    {"alpha", 1.0, {{130, 54, 0}, {130, 54, 0}, {129, 54, 0}}},
    {"alpha", 1.2, {{130, 54, 0}, {130, 54, 0}, {125, 52, 0}}},
    {"alpha", 1.5, {{130, 54, 0}, {130, 52, 0}, {122, 47, 0}}},
    {"alpha", 0.8, {{130, 54, 0}, {130, 54, 0}, {130, 55, 300}}},
};

std::vector<uint32_t> contour_points(const GridWall& wall, const Row& row) {
  Task task;
  const double size = row.spacings * kContourModesSpacing;
  const std::string rule = row.rule;
  if (rule == "long edges")
    return long_edge_points(wall.band.points, all_triangles(wall.band, task), size);
  if (rule == "short triangles") return on_rings(wall, short_triangles(wall.band, size, task));
  return on_rings(wall, alpha_triangles(wall.band, size, 0, task));
}

}  // namespace

TEST_CASE("contour__hits_of_each_rule_are_those_of_the_table") {
  for (const Row& row : kTable)
    for (size_t j = 0; j < 3; ++j) {
      const GridWall wall(kJitters_m[j]);
      const Hits found = hits(wall, contour_points(wall, row)), &expected = row.expected[j];
      CAPTURE(row.rule);
      CAPTURE(row.spacings);
      CAPTURE(kJitters_m[j]);
      MESSAGE("FIGURE " << std::string(row.rule) << " " << row.spacings << "p, jitter "
                        << 1000 * kJitters_m[j] << " mm: " << found.outer << " / " << found.hole
                        << " / " << found.inner);
      // Another seed than theirs: some counts more or less.
      CHECK(std::abs(found.outer - expected.outer) <= 8);
      CHECK(std::abs(found.hole - expected.hole) <= 8);
      CHECK(std::abs(found.inner - expected.inner) <= (expected.inner == 0 ? 0 : 60));
    }
}

TEST_CASE("contour__the_long_edge_threshold_lies_at_the_knee") {
  Task task;
  const GridWall wall(0.010);
  const auto lengths = edge_lengths(wall.band.points, all_triangles(wall.band, task));
  CHECK(std::is_sorted(lengths.begin(), lengths.end()));
  const double threshold = long_edge_threshold(lengths, kContourModesSpacing);
  MESSAGE("FIGURE knee at " << threshold / kContourModesSpacing << " spacings");
  CHECK(threshold >= 2 * kContourModesSpacing);  // above every ordinary edge
  CHECK(threshold <= 5 * kContourModesSpacing);
  CHECK(long_edge_threshold({}, kContourModesSpacing) == doctest::Approx(3 * kContourModesSpacing));
}

TEST_CASE("contour__both_modes_find_the_window_and_alpha_closes_its_corners") {
  Task task;
  const GridWall wall(0.010);
  ContourSetting setting;
  double nearest[2] = {INFINITY, INFINITY};
  for (const ContourMode mode : {ContourMode::kAlpha, ContourMode::kLongEdge}) {
    setting.mode = mode;
    setting.alpha_factor = 1.2;
    const Contour contour = extract_contour(wall.band.points, setting, task);
    REQUIRE(contour.pieces.size() == 1);
    REQUIRE(contour.pieces[0].openings.size() == 1);
    const Vec2 corner{0.9, 0.9};  // the wall's last point before the window's lower left corner
    for (const Vec2& p : contour.pieces[0].openings[0])
      nearest[static_cast<int>(mode)] = std::min(nearest[static_cast<int>(mode)], norm(p - corner));
  }
  CHECK(nearest[0] < 1.5 * kContourModesSpacing);
  CHECK(nearest[0] <= nearest[1]);
}

TEST_CASE("contour__alpha_follows_the_local_spacing") {
  // The left half is four times as dense as the right one. A slit three points wide on the left is open, one as wide on
  // the right, where it takes one column of points away, is closed.
  std::vector<Vec2> points;
  for (double u = 0.02; u < 4; u += 0.04)
    for (double v = 0.02; v < 3; v += 0.04)
      if (!(u > 1 && u < 1.09 && v > 0.5 && v < 2.5)) points.push_back({u, v});
  for (double u = 4.04; u < 8; u += 0.08)
    for (double v = 0.04; v < 3; v += 0.08)
      if (!(u > 6 && u < 6.09 && v > 0.5 && v < 2.5)) points.push_back({u, v});
  Task task;
  ContourSetting setting;
  setting.alpha_factor = 1.2;
  setting.min_opening_width_m = 0.05;
  const Contour contour = extract_contour(points, setting, task);
  REQUIRE(contour.pieces.size() == 1);
  REQUIRE(contour.pieces[0].openings.size() == 1);
  CHECK(contour.pieces[0].openings[0][0].u < 4);
}
