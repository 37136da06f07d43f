// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/set_back.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "base/random.h"
#include "modelling/evidence/cell_classes.h"
#include "modelling/plane/segment_frame.h"
#include "unit/modelling/walls.h"

using namespace jalon;

namespace {

constexpr double kBlindPitch_m = 0.03, kBlindNoise_m = 0.005;

// A wall of 9 x 4 m whose points lie this far behind it, NaN where it has none; noise of a seed. What was measured
// there lies on the wall, elsewhere behind it.
std::vector<RingBox> found_in(const std::function<double(double, double)>& depth_m, uint64_t seed,
                              std::vector<uint8_t>* marked = nullptr) {
  RandomStream random(seed, 1);
  std::vector<Vec3> points;
  for (double u = kBlindPitch_m / 2; u < 9; u += kBlindPitch_m)
    for (double v = kBlindPitch_m / 2; v < 4; v += kBlindPitch_m)
      if (const double depth = depth_m(u, v); !std::isnan(depth))
        points.push_back({u, depth + kBlindNoise_m * random.normal(), v});
  const Segmentation segmentation = walls::segmentation_of({points});
  std::vector<uint32_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), 0u);
  const CellSource source{segment_frame(segmentation, segmentation.segments[0], indices), indices,
                          kBlindNoise_m, 1};
  WallCells cells;
  cells.frame = source.frame;
  cells.on_m = 0.03;
  cells.spacing_m = kBlindPitch_m;
  cells.cell_m = 2.2 * kBlindPitch_m;
  cells.origin = {INFINITY, INFINITY};
  for (const Vec3& p : points) {
    const Vec2 at = cells.frame.project(p);
    cells.origin = {std::min(cells.origin.u, at.u), std::min(cells.origin.v, at.v)};
  }
  cells.columns = static_cast<uint32_t>(9 / cells.cell_m) + 1;
  cells.rows = static_cast<uint32_t>(4 / cells.cell_m) + 1;
  std::vector<uint8_t> marks(static_cast<size_t>(cells.columns) * cells.rows, kMarkBehind);
  HeightSums heights(marks.size());
  for (const Vec3& p : points) {
    const Vec2 at = (cells.frame.project(p) - cells.origin) * (1 / cells.cell_m);
    const size_t k = static_cast<size_t>(at.v) * cells.columns + static_cast<size_t>(at.u);
    marks[k] = kMarkOn;
    heights.add(k, dot(p - cells.frame.origin, cells.frame.normal) - cells.frame.height);
  }
  Task task;
  std::vector<RingBox> out = mark_set_back(heights, cells, marks, task);
  for (RingBox& box : out)
    box = {box.low - cells.origin, box.high - cells.origin};  // the wall's corner is its origin
  if (marked != nullptr) *marked = marks;
  return out;
}

bool holds(const RingBox& box, double u, double v) { return box.holds({u, v}); }

bool is_like(const RingBox& found, const RingBox& truth) { return overlap(found, truth) >= 0.9; }

// Three windows of 2 x 2 m, from u = 0.5, 3.5 and 6.5 on; blinds hang down to these heights.
double windows(double u, double v, double first, double second, double third, double depth_m) {
  const double down[] = {first, second, third};
  for (int k = 0; k < 3; ++k)
    if (holds({{0.5 + 3 * k, 1}, {2.5 + 3 * k, 3}}, u, v)) return v > down[k] ? depth_m : NAN;
  return 0;
}

}  // namespace

TEST_CASE("set_back__blinds_are_found_where_the_opening_goes_on_or_has_its_like") {
  for (const double depth_m : {0.017, 0.02, 0.025})
    for (uint64_t seed = 1; seed <= 4; ++seed) {
      CAPTURE(depth_m);
      CAPTURE(seed);
      std::vector<uint8_t> marks;
      const std::vector<RingBox> found = found_in(
          [&](double u, double v) { return windows(u, v, 2, 1, 3, depth_m); }, seed, &marks);
      REQUIRE(found.size() == 2);
      CHECK(is_like(found[0], {{0.5, 2}, {2.5, 3}}));
      CHECK(is_like(found[1], {{3.5, 1}, {5.5, 3}}));
      const auto through = std::count(marks.begin(), marks.end(), kMarkBehind);
      const double cell_m2 = std::pow(2.2 * kBlindPitch_m, 2);
      CHECK(static_cast<double>(through) * cell_m2 == doctest::Approx(12).epsilon(0.05));
    }
}

TEST_CASE("set_back__panels_of_a_wall_have_no_like_among_its_openings") {
  CHECK(found_in([](double u, double v) { return windows(u, v, 1, 1, 1, 0.02); }, 1).empty());
  // Windows of other sizes beside them.
  CHECK(found_in(
            [](double u, double v) {
              if (holds({{6, 1.5}, {7, 3.5}}, u, v)) return static_cast<double>(NAN);
              return holds({{1, 1}, {3, 2.5}}, u, v) ? 0.02 : 0;
            },
            1)
            .empty());
}

TEST_CASE("set_back__a_wall_that_bends_has_no_step") {
  // As far behind as a blind beside an opening of the same width, without an edge.
  const auto bends = [](double u, double v) {
    if (holds({{3, 0.5}, {6, 1.5}}, u, v)) return static_cast<double>(NAN);
    return 0.025 * std::exp(-0.5 * (std::pow((u - 4.5) / 1.2, 2) + std::pow((v - 2.5) / 0.7, 2)));
  };
  for (uint64_t seed = 1; seed <= 4; ++seed) CHECK(found_in(bends, seed).empty());
}
