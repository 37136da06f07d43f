// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "compare/distance/model_sample.h"
#include "compare/volumes/mesh_closure.h"
#include "compare/volumes/volume.h"

using namespace jalon;

namespace {

constexpr double kNoise_m = 0.01;

Cloud volume_cloud_of(const std::vector<Vec3>& points) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int a = 0; a < 3; ++a) xyz[3 * i + static_cast<size_t>(a)] = points[i][a];
  return make_cloud(std::move(xyz));
}

/// A slope of 40 x 30 m with noise; after: a pit of 8 x 5 x 1.2 m and a cone of 3 m radius and 1 m height on it.
double ground(double x, double y) { return 100 + 0.1 * x - 0.05 * y; }
double pit(double x, double y) { return x > 5 && x < 13 && y > 8 && y < 13 ? -1.2 : 0; }
double heap(double x, double y) { return std::max(0.0, 1 - std::hypot(x - 28, y - 15) / 3); }
constexpr double kPit_m3 = 8 * 5 * 1.2, kHeap_m3 = std::numbers::pi * 9 / 3;

Cloud survey(bool after, uint64_t seed, size_t points = 250000, bool with_shadow = false) {
  RandomStream random(seed, 1);
  std::vector<Vec3> out;
  while (out.size() < points) {
    const double x = 40 * random.uniform(), y = 30 * random.uniform();
    // Twice as dense to the left, as near a scanner.
    if (x > 20 && random.uniform() < 0.5) continue;
    if (with_shadow && x > 33 && x < 36 && y > 20 && y < 24) continue;
    const double z =
        ground(x, y) + (after ? pit(x, y) + heap(x, y) : 0) + kNoise_m * random.normal();
    out.push_back({x, y, z});
  }
  return volume_cloud_of(out);
}

double of(const Volume& volume, const char* name) { return volume.summary.require(name).number(0); }

/// A box with its corners anticlockwise seen from outside; without its top: open.
Model box(const Vec3& from, const Vec3& size, bool with_top = true) {
  Model model;
  for (int i = 0; i < 8; ++i)
    model.vertices.push_back(from +
                             Vec3{i & 1 ? size.x : 0, i & 2 ? size.y : 0, i & 4 ? size.z : 0});
  model.triangles = {{0, 3, 1}, {0, 2, 3}, {0, 1, 5}, {0, 5, 4}, {1, 3, 7}, {1, 7, 5},
                     {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}, {4, 5, 7}, {4, 7, 6}};
  if (!with_top) model.triangles.resize(10);
  model.triangle_faces.resize(model.triangles.size(), 0);
  return model;
}

/// The ground as a mesh of squares of 0.25 m, before or after.
Model terrain(bool after) {
  Model model;
  constexpr uint32_t nx = 161, ny = 121;
  for (uint32_t j = 0; j < ny; ++j)
    for (uint32_t i = 0; i < nx; ++i) {
      const double x = 0.25 * i, y = 0.25 * j;
      model.vertices.push_back({x, y, ground(x, y) + (after ? heap(x, y) : 0)});
    }
  for (uint32_t j = 0; j + 1 < ny; ++j)
    for (uint32_t i = 0; i + 1 < nx; ++i) {
      const uint32_t a = j * nx + i;
      model.triangles.push_back({a, a + 1, a + nx + 1});
      model.triangles.push_back({a, a + nx + 1, a + nx});
    }
  model.triangle_faces.resize(model.triangles.size(), 0);
  return model;
}

}  // namespace

TEST_CASE("volume__of_a_pit_and_a_heap_is_right_to_one_percent") {
  const Cloud before = survey(false, 1), after = survey(true, 2);
  Task task;
  for (const auto& [name, value] : {std::pair{"mean", CellValue::kMean},
                                    {"median", CellValue::kMedian},
                                    {"interpolated", CellValue::kInterpolated}}) {
    VolumeSettings settings;
    settings.cell_value = value;
    settings.cell_m = 0.25;  // nine points in a cell where they are thin, which leaves few empty
    settings.dead_band_m = 0.02;
    const Volume found = volume_between(before, after, settings, task);
    MESSAGE("FIGURE volume by ", std::string(name), ": cut ", of(found, "cut"), " of ", kPit_m3,
            " m3, fill ", of(found, "fill"), " of ", kHeap_m3, " m3, cells of ", of(found, "cell"),
            " m");
    CHECK(std::abs(of(found, "cut") - kPit_m3) < 0.01 * kPit_m3);
    CHECK(std::abs(of(found, "fill") - kHeap_m3) < 0.01 * kHeap_m3);
    CHECK(of(found, "net") == doctest::Approx(of(found, "fill") - of(found, "cut")));
    CHECK(of(found, "area") == doctest::Approx(40 * 30).epsilon(0.02).scale(0));
  }
}

TEST_CASE("volume__of_nothing_moved_lies_within_its_sigma") {
  Task task;
  double squares = 0;
  constexpr int kRuns = 20;
  for (int run = 0; run < kRuns; ++run) {
    const Volume found =
        volume_between(survey(false, 10 + static_cast<uint64_t>(run), 20000),
                       survey(false, 60 + static_cast<uint64_t>(run), 20000), {}, task);
    squares += std::pow(of(found, "net") / of(found, "sigma"), 2);
  }
  MESSAGE("FIGURE net volume over its sigma, where nothing moved: ", std::sqrt(squares / kRuns));
  // Chi-square of 20 degrees of freedom, 0.1 % on either side.
  CHECK(squares > 5.9);
  CHECK(squares < 45.3);
}

TEST_CASE("volume__lists_and_counts_the_cells_without_data") {
  const Cloud before = survey(false, 1), after = survey(false, 2, 250000, true);
  Task task;
  VolumeSettings settings;
  settings.cell_m = 0.5;
  const Volume found = volume_between(before, after, settings, task);
  CHECK(of(found, "without_compared") == 6 * 8);
  const auto status = found.cells.require("status").values<uint8_t>();
  size_t listed = 0;
  for (size_t i = 0; i < status.size(); ++i) {
    if (status[i] != 2) continue;
    ++listed;
    CHECK(std::isnan(found.cells.require("difference").number(i)));
    CHECK(found.cells.require("xyz").number(i, 0) > 33);
    CHECK(found.cells.require("compared_points").number(i) == 0);
  }
  CHECK(listed == 6 * 8);
}

// A point of no survey, a hundred kilometres off: the cells between are counted, and nothing else is done with them.
TEST_CASE("volume__of_a_survey_and_a_far_point_is_that_of_the_survey") {
  const auto with_stray = [](const Cloud& cloud) {
    std::vector<Vec3> points = {{-100000.75, 15, 100}};
    for (size_t i = 0; i < cloud.size(); ++i) points.push_back(cloud.point(i));
    return volume_cloud_of(points);
  };
  const Cloud before = survey(false, 1, 20000), after = survey(true, 2, 20000);
  for (const CellValue value : {CellValue::kMean, CellValue::kInterpolated}) {
    Task task;
    VolumeSettings settings;
    settings.cell_m = 0.5;
    settings.cell_value = value;
    const Volume alone = volume_between(before, after, settings, task),
                 both = volume_between(with_stray(before), with_stray(after), settings, task);
    for (const char* name : {"cut", "fill", "net", "sigma", "mean_difference"})
      CHECK(of(both, name) == doctest::Approx(of(alone, name)).epsilon(1e-3));
    CHECK(of(both, "cells") == of(alone, "cells") + 1);
    const double columns = 80 + 2 * 100001, rows = 60;
    CHECK(of(both, "cells") + of(both, "without_reference") + of(both, "without_compared") +
              of(both, "without_data") ==
          columns * rows);
    const Column& column = both.cells.require("column");
    double most = 0;
    for (size_t i = 0; i < column.count(); ++i) most = std::max(most, column.number(i));
    CHECK(most == columns - 1);
  }
}

TEST_CASE("volume__along_another_direction") {
  // A wall that moved by 0.1 m along x.
  std::vector<Vec3> before, after;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 50; ++j) {
      before.push_back({3, 0.05 + 0.1 * i, 0.05 + 0.1 * j});
      after.push_back({3.1, 0.05 + 0.1 * i, 0.05 + 0.1 * j});
    }
  VolumeSettings settings;
  settings.direction = {2, 0, 0};
  settings.cell_m = 0.5;
  Task task;
  const Volume found =
      volume_between(volume_cloud_of(before), volume_cloud_of(after), settings, task);
  CHECK(of(found, "fill") == doctest::Approx(10 * 5 * 0.1).epsilon(1e-12));
  CHECK(of(found, "cut") == 0);
  settings.direction = {0, 0, 0};
  CHECK_THROWS_AS(volume_between(volume_cloud_of(before), volume_cloud_of(after), settings, task),
                  Error);
}

TEST_CASE("volume__of_closed_meshes_is_exact_and_open_ones_are_told") {
  Task task;
  const Model small = box({652000, 6861000, 30}, {2, 3, 4}),
              large = box({652000, 6861000, 30}, {3, 3, 5});
  const Volume found = volume_between(small, large, {}, task);
  CHECK(of(found, "net") == doctest::Approx(45 - 24).epsilon(1e-12));
  CHECK(of(found, "reference_volume") == doctest::Approx(24).epsilon(1e-12));
  CHECK(found.cells.size() == 0);
  const Model open = box({652000, 6861000, 30}, {2, 3, 4}, false);
  const MeshClosure closure = closure_of(open.vertices, open.triangles, task);
  CHECK(closure.border_sides == 4);
  CHECK(closure.inconsistent_sides == 0);
  VolumeSettings settings;
  settings.surfaces = VolumeSettings::Surfaces::kClosed;
  CHECK_THROWS_AS(volume_between(open, large, settings, task), Error);
  Model turned = small;
  std::swap(turned.triangles[11][0], turned.triangles[11][1]);
  CHECK(closure_of(turned.vertices, turned.triangles, task).inconsistent_sides == 3);
}

TEST_CASE("volume__between_open_meshes_by_prisms") {
  Task task;
  const Volume found = volume_between(terrain(false), terrain(true), {}, task);
  MESSAGE("FIGURE heap between two terrain meshes: ", of(found, "fill"), " of ", kHeap_m3, " m3");
  CHECK(std::abs(of(found, "fill") - kHeap_m3) < 0.01 * kHeap_m3);
  CHECK(of(found, "cut") < 1e-6);
  CHECK(std::isnan(of(found, "reference_volume")));
}

TEST_CASE("volume__same_bits_for_any_threads") {
  const Cloud before = survey(false, 1, 30000), after = survey(true, 2, 30000);
  VolumeSettings settings;
  settings.cell_value = CellValue::kInterpolated;
  const auto run = [&](unsigned threads) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    return volume_between(before, after, settings, task);
  };
  const Volume one = run(1), four = run(4);
  for (const FieldTable* pair : {&one.summary, &one.cells})
    for (const ColumnPtr& column : *pair) {
      const Column& again =
          (pair == &one.summary ? four.summary : four.cells).require(column->info().name);
      REQUIRE(again.bytes() == column->bytes());
      CHECK(std::memcmp(again.raw(), column->raw(), column->bytes()) == 0);
    }
}

TEST_CASE("model_sample__is_uniform_by_area_with_normals_and_faces") {
  Model model;
  model.parts = {Part{"slab", "slab"}};
  Face face;
  face.plane = {{0, 0, 1}, 0};
  model.add_face(face, {{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}},
                        {{1, 0.5, 0}, {1, 1.5, 0}, {2, 1.5, 0}, {2, 0.5, 0}}});
  face.plane = {{1, 0, 0}, 4};
  model.add_face(face, {{{4, 0, 0}, {4, 2, 0}, {4, 2, 1}, {4, 0, 1}}});
  Task task;
  const Cloud cloud = sample_model(model, {.points = 9000}, task);
  REQUIRE(cloud.size() == 9000);
  size_t first = 0, left = 0;
  const auto faces = cloud.fields.require("face").values<uint32_t>();
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 p = cloud.point(i);
    first += faces[i] == 0 ? 1 : 0;
    left += faces[i] == 0 && p.x < 1 ? 1 : 0;
    if (faces[i] == 0) {
      CHECK_FALSE((p.x > 1 && p.x < 2 && p.y > 0.5 && p.y < 1.5));
      CHECK(std::abs(p.z) < 1e-12);
    }
    CHECK(cloud.fields.require("normal").number(i, faces[i] == 0 ? 2 : 0) == doctest::Approx(1));
  }
  CHECK(std::abs(static_cast<double>(first) - 7000) <
        2 * 20);                                            // 7 of 9 m2, to two points a triangle
  CHECK(std::abs(static_cast<double>(left) - 2000) < 150);  // 2 of 9 m2: binomial, four sigma
}
