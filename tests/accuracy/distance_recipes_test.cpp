// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Distances between clouds: the cooling tower of Girardeau-Montaut 2006, 5.3.2, and the exact search against brute
// force. How long the clouds of its tables take: tests/bench/thesis_clouds.cpp.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/random.h"
#include "bench/rolling_ground.h"
#include "compare/distance/distance.h"
#include "recipe.h"

namespace jalon::distance_recipes_test {

using namespace jalon::test;

namespace {

// A strip of the shell (of a cooling tower; Girardeau-Montaut 2006, 5.3.2): 260 points a square
// metre, at a normal offset that varies along it.
std::vector<double> tower(size_t points, uint64_t seed, double noise_m, double offset_m) {
  RandomStream random(seed, 0);
  std::vector<double> xyz;
  const auto radius = [](double z) { return 35 * std::sqrt(1 + (z - 135) * (z - 135) / 8100); };
  const double height = 20;
  const double sector = static_cast<double>(points) / 260 / height / radius(60);
  for (size_t i = 0; i < points; ++i) {
    const double z = 50 + height * random.uniform(), theta = sector * random.uniform();
    const double r = radius(z), slope = 35 * 35 * (z - 135) / 8100 / r;  // dr / dz
    const double out =
        noise_m * random.normal() + offset_m * std::numbers::sqrt2 * std::sin(0.9 * z);
    const double across = out / std::sqrt(1 + slope * slope);
    xyz.insert(xyz.end(), {(r + across) * std::cos(theta), (r + across) * std::sin(theta),
                           z - across * slope});
  }
  return xyz;
}

}  // namespace

// Octree spec 9 (7): noise of 1 and 2.5 cm and offsets of 1.41 cm make a normal difference of 3.04 cm.
TEST_CASE("tower__plain_distances_are_biased_by_sampling_and_local_models_are_not") {
  const size_t points = is_full() ? 2000000 : 150000;
  const auto reference = cloud_of(tower(points, 1, 0.01, 0)),
             compared = cloud_of(tower(points, 2, 0.025, 0.0141));
  Task task;
  const auto shares = [&](const char* name, LocalModelKind model) {
    const Comparison made = compare_distance(reference, compared, {.local_model = model}, task);
    double below5 = 0, below10 = 0;
    for (const double d : made.points.require("distance").values<double>()) {
      below5 += d < 0.05;
      below10 += d < 0.10;
    }
    const double mean = made.summary.require("mean").number(0);
    const auto n = static_cast<double>(points);
    MESSAGE("FIGURE tower, local model " << std::string(name) << ": mean " << 100 * mean << " cm, "
                                         << 100 * below5 / n << " % below 5 cm, "
                                         << 100 * below10 / n << " % below 10 cm");
    return std::array{mean, below5 / n, below10 / n};
  };
  const auto plain = shares("none", LocalModelKind::kNone);
  CHECK((plain[0] > 0.03 && plain[0] < 0.045));
  for (const auto& [name, model] : {std::pair{"plane", LocalModelKind::kPlane},
                                    {"delaunay", LocalModelKind::kDelaunay},
                                    {"quadric", LocalModelKind::kQuadric}}) {
    const auto modelled = shares(name, model);
    CHECK(modelled[0] < plain[0] - 0.01);
    CHECK(modelled[1] > 0.88);
    CHECK(modelled[2] >= 0.999);
  }
}

TEST_CASE("nearest_points__equal_brute_force_to_1e9_on_uneven_clouds") {
  const size_t points = is_full() ? 60000 : 6000;
  const auto reference = earthworks(points, 5, false), compared = earthworks(points, 6, true);
  Task task;
  const Comparison made = compare_distance(reference, compared, {}, task);
  const auto distance = made.points.require("distance").values<double>();
  double worst = 0;
  for (size_t i = 0; i < points; ++i) {
    const Vec3 p = compared->point(i);
    double least = 1e300;
    for (size_t j = 0; j < points; ++j)
      least = std::min(least, squared_norm(reference->point(j) - p));
    worst = std::max(worst, std::fabs(distance[i] / std::sqrt(least) - 1));
  }
  MESSAGE("FIGURE nearest points of " << points << ": within " << worst << " of brute force");
  CHECK(worst < 1e-9);
}

}  // namespace jalon::distance_recipes_test
