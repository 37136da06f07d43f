// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Distances of clouds from meshes at the sizes of Girardeau-Montaut 2006, table 2.1.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <numbers>

#include "base/random.h"
#include "compare/distance/model_distance.h"
#include "compare/distance/model_sample.h"

using namespace jalon;

namespace {

constexpr double kNoise_m = 0.002;

bool sanitized() { return std::getenv("JALON_SANITIZED") != nullptr; }

/// A plant room: 20 beams, 60 pipes of 3 to 30 cm and 5 tanks with 8 to 12 facets, in bands
/// along their axes. Exactly so many triangles: bands as long as it takes.
class PlantMesh {
 public:
  PlantMesh(size_t triangles, bool with_all_pipes) {
    RandomStream random(4, 0);
    std::vector<Tube> tubes;
    for (int i = 0; i < 85; ++i) {
      const Vec3 foot{1 + 10 * random.uniform(), 1 + 6 * random.uniform(), 4 * random.uniform()};
      const int axis = static_cast<int>(random.below(3));
      const double radius = i < 60   ? 0.03 + 0.27 * random.uniform() * random.uniform()
                            : i < 80 ? 0.15
                                     : 0.8;
      const double length = i < 80 ? 1 + 3 * random.uniform() : 1.5;
      tubes.push_back({foot, axis, radius, length,
                       i < 60   ? 8 + static_cast<uint32_t>(i % 5)
                       : i < 80 ? 4u
                                : 12u});
    }
    if (!with_all_pipes) tubes.erase(tubes.begin() + 50, tubes.begin() + 55);
    uint32_t facets = 0;
    for (const Tube& tube : tubes) facets += tube.facets;
    const auto bands = static_cast<uint32_t>(triangles / (2 * facets) + 1);
    for (const Tube& tube : tubes) add(tube, bands);
    model_.triangles.resize(triangles);
    model_.triangle_faces.resize(triangles, 0);
  }
  Model take() { return std::move(model_); }

 private:
  struct Tube {
    Vec3 foot;
    int axis;
    double radius, length;
    uint32_t facets;
  };
  void add(const Tube& tube, uint32_t bands) {
    const auto first = static_cast<uint32_t>(model_.vertices.size());
    for (uint32_t b = 0; b <= bands; ++b)
      for (uint32_t f = 0; f < tube.facets; ++f) {
        const double turn = 2 * std::numbers::pi * f / tube.facets;
        Vec3 p = tube.foot;
        p[tube.axis] += tube.length * b / bands;
        p[(tube.axis + 1) % 3] += tube.radius * std::cos(turn);
        p[(tube.axis + 2) % 3] += tube.radius * std::sin(turn);
        model_.vertices.push_back(p);
      }
    for (uint32_t b = 0; b < bands; ++b)
      for (uint32_t f = 0; f < tube.facets; ++f) {
        const uint32_t next = (f + 1) % tube.facets, here = first + b * tube.facets,
                       there = here + tube.facets;
        model_.triangles.push_back({here + f, here + next, there + next});
        model_.triangles.push_back({here + f, there + next, there + f});
      }
  }
  Model model_;
};

/// The room as scanned: five pipes more than the mesh has, and noise.
CloudPtr scan_of_room(size_t points, Task& task) {
  const Cloud exact = sample_model(PlantMesh(5000, true).take(), {.points = points}, task);
  Buffer<double> xyz(3 * points);
  RandomStream random(5, 0);
  for (size_t i = 0; i < xyz.size(); ++i) xyz[i] = exact.xyz()[i] + kNoise_m * random.normal();
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

struct Row {
  size_t points, triangles;
  double printed_s;  ///< at the best level
};
constexpr Row kTable21[] = {{293587, 38044, 7.6},     {2180182, 24155, 46.94},
                            {2725142, 141494, 49.19}, {2725142, 53254, 38.03},
                            {2975731, 10089, 24.56},  {3412681, 16553, 74.77}};

}  // namespace

TEST_CASE("mesh_recipes__table_2_1_thirty_times_faster_than_printed") {
  Task::Hooks hooks;
  hooks.threads = 1;
  Task task(hooks);
  const size_t share = sanitized() ? 100 : 1;
  double sum = 0, printed = 0;
  for (const Row& row : kTable21) {
    const CloudPtr cloud = scan_of_room(row.points / share, task);
    const auto mesh = std::make_shared<const Model>(PlantMesh(row.triangles / share, false).take());
    const std::clock_t start = std::clock();
    const Comparison made = compare_with_model(mesh, cloud, {}, task);
    const double s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    MESSAGE("FIGURE table 2.1: " << row.points << " points, " << row.triangles << " triangles " << s
                                 << " s, printed " << row.printed_s << " s, " << row.printed_s / s
                                 << " x faster");
    CHECK(made.summary.require("compared").number(0) == static_cast<double>(cloud->size()));
    sum += s;
    printed += row.printed_s;
    if (!sanitized()) CHECK(row.printed_s / s > 10);
  }
  MESSAGE("FIGURE table 2.1 in all: "
          << printed / sum << " x faster than printed, one thread, indexes included, signed");
  if (!sanitized()) CHECK(printed / sum > 30);
}
