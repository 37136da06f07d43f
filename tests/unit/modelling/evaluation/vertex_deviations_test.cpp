// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Homologous vertices and their deviations.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "base/random.h"
#include "modelling/evaluation/vertex_deviations.h"

using namespace jalon;

TEST_CASE("vertex_deviations__give_the_recomputed_figures_of_table_5_8") {
  // Boulaassal 2010, table 5.8: DX, DY, DZ (m) as printed.
  const Vec3 printed[] = {{0.035, -0.007, -0.012}, {0.035, -0.003, 0.021}, {-0.005, 0.004, 0.002},
                          {-0.003, 0.019, 0.024},  {-0.001, 0.005, 0.016}, {0.072, -0.012, 0.018},
                          {-0.063, 0.015, 0.022},  {-0.008, 0.018, 0.016}, {-0.060, 0.011, 0.004},
                          {-0.025, -0.016, -0.027}};
  const double norms_mm[] = {37.7, 40.9, 6.7, 30.8, 16.8, 75.2, 68.4, 25.4, 61.1, 40.1};
  std::vector<VertexPair> pairs;
  for (uint32_t i = 0; i < 10; ++i) {
    pairs.push_back({i, i, printed[i]});
    CHECK(std::fabs(1000 * pairs[i].distance_m() - norms_mm[i]) < 0.06);
  }
  FieldTable t;
  add_vertex_totals(t, pairs);
  const auto mm = [&](const char* name) { return 1000 * t.require(name).number(0); };
  MESSAGE("FIGURE table 5.8: mean D ", mm("mean_distance"), ", std ", mm("std_distance"), ", rms ",
          mm("rms_distance"), ", rms per axis ", mm("rms_dx"), " ", mm("rms_dy"), " ", mm("rms_dz"),
          " mm");
  CHECK(std::fabs(mm("mean_distance") - 40) < 0.5);
  CHECK(std::fabs(mm("std_distance") - 22) < 0.5);
  CHECK(std::fabs(mm("rms_distance") - 45) < 0.5);
  const double rms[] = {39.9, 12.4, 18.0}, mean[] = {-2.3, 3.4, 8.4};
  const char* axes[] = {"dx", "dy", "dz"};
  for (size_t i = 0; i < 3; ++i) {
    CHECK(std::fabs(mm(("rms_" + std::string(axes[i])).c_str()) - rms[i]) < 0.06);
    CHECK(std::fabs(mm(("mean_" + std::string(axes[i])).c_str()) - mean[i]) < 0.06);
  }
}

TEST_CASE("vertex_deviations__pair_the_nearest_first_and_one_to_one") {
  Task task;
  const Vec3 a[] = {{0, 0, 0}, {0.1, 0, 0}, {5, 0, 0}},
             r[] = {{0.08, 0, 0}, {0.2, 0, 0}, {5.2, 0, 0}};
  const auto pairs = homologous_vertices(a, r, 0.15, task);
  REQUIRE(pairs.size() == 1);  // a[1] with r[0]; a[0] - r[1] and a[2] - r[2] are too far apart
  CHECK(pairs[0].automatic == 1);
  CHECK(pairs[0].reference == 0);
  CHECK(homologous_vertices(a, r, 0.25, task).size() == 3);
  CHECK(homologous_vertices({}, r, 1, task).empty());
}

TEST_CASE("vertex_deviations__are_normalised_by_their_covariance") {
  const double sx = 0.001, sy = 0.004, sz = 0.02;
  const std::array<double, 9> c{sx * sx, 0, 0, 0, sy * sy, 0, 0, 0, sz * sz};
  CHECK(normalised_deviation({2 * sx, 0, 0}, c) == doctest::Approx(2));
  CHECK(normalised_deviation({sx, sy, -sz}, c) == doctest::Approx(std::sqrt(3)));
  CHECK(normalised_deviation({}, c) == 0);
  std::array<double, 9> unknown = c;
  unknown[8] = kNaN;
  CHECK(std::isnan(normalised_deviation({sx, 0, 0}, unknown)));
  std::array<double, 9> flat = c;  // nothing may move along x
  flat[0] = 0;
  CHECK(normalised_deviation({0.01, 0, 0}, flat) == std::numeric_limits<double>::infinity());
  CHECK(normalised_deviation({0, sy, 0}, flat) == doctest::Approx(1));
}

TEST_CASE("vertex_deviations__take_the_pairs_that_a_look_at_all_of_them_takes") {
  RandomStream random(5, 81);
  std::vector<Vec3> a, r;
  for (int i = 0; i < 60; ++i) {
    a.push_back({random.uniform(), random.uniform(), 0.2 * random.uniform()});
    r.push_back({random.uniform(), random.uniform(), 0.2 * random.uniform()});
  }
  const double tolerance_m = 0.15;
  std::vector<std::pair<size_t, size_t>> expected(r.size(), {r.size(), 0});
  std::vector<int> used(a.size(), 0), taken(r.size(), 0);
  for (;;) {  // the nearest pair of all that are left
    double least = tolerance_m;
    size_t best_a = a.size(), best_r = 0;
    for (size_t i = 0; i < a.size(); ++i)
      for (size_t k = 0; k < r.size(); ++k)
        if (used[i] == 0 && taken[k] == 0 && norm(a[i] - r[k]) <= least) {
          least = norm(a[i] - r[k]);
          best_a = i;
          best_r = k;
        }
    if (best_a == a.size()) break;
    used[best_a] = taken[best_r] = 1;
    expected[best_r] = {best_r, best_a};
  }
  Task task;
  const auto pairs = homologous_vertices(a, r, tolerance_m, task);
  size_t at = 0;
  for (const auto& [ref, automatic] : expected) {
    if (ref == r.size()) continue;
    REQUIRE(at < pairs.size());
    CHECK(pairs[at].reference == ref);
    CHECK(pairs[at].automatic == automatic);
    CHECK(pairs[at].deviation == a[automatic] - r[ref]);
    ++at;
  }
  CHECK(at == pairs.size());
  CHECK(at > 20);
}
