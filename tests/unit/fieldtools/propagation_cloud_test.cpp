// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Regions of a cloud by propagation against hills whose places are known, and the table against the labels.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "fieldtools/propagation.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// A plane of 4 x 2 m with two plateaus of radius 0.6 and 0.35 m. Up to 0.1 m within their rims the gradient is 1, from
// where a front does not go down to the 0 of the rest; only the core, more than a cell's diagonal further in, is high
// enough to start one.
struct Plateaus {
  Cloud cloud;
  std::vector<double> deviations, gradients;
  std::vector<int> truth;  ///< 1, 2: core of a plateau; 0: beyond its rim; -1 between

  Plateaus() {
    RandomStream random(1, 6);
    std::vector<Vec3> points(8000);
    for (Vec3& p : points) {
      p = {4 * random.uniform(), 2 * random.uniform(), 0};
      const double a = 0.6 - std::hypot(p.x - 1, p.y - 1), b = 0.35 - std::hypot(p.x - 3, p.y - 1);
      const double depth = std::max(a, b);
      const double height = a > b ? 1 : 1.5;
      deviations.push_back(depth > 0.25 ? height + 0.01 * random.uniform() : 0);
      gradients.push_back(depth > 0.1 ? 1 : 0);
      truth.push_back(depth > 0.25 ? (a > b ? 1 : 2) : depth < 0 ? 0 : -1);
    }
    cloud = cloud_of(points);
  }
  PropagationResult found(const PropagationSettings& settings) const {
    Task task;
    return segment_by_propagation(cloud, deviations, gradients, settings, task);
  }
};

PropagationSettings cells_of_10_cm() {
  PropagationSettings out;
  out.cell_m = 0.1;
  out.minimum_seed = 0.5;
  return out;
}

}  // namespace

TEST_CASE("segment_by_propagation__a_region_a_plateau_the_larger_one_first") {
  const Plateaus scene;
  const PropagationResult found = scene.found(cells_of_10_cm());
  size_t wrong = 0;
  for (size_t i = 0; i < scene.truth.size(); ++i)
    if (scene.truth[i] > 0) wrong += found.labels[i] != static_cast<uint32_t>(scene.truth[i]);
  CHECK(wrong == 0);
  for (size_t i = 0; i < scene.truth.size(); ++i)
    if (scene.truth[i] == 0) CHECK(found.labels[i] == 0);
}

TEST_CASE("segment_by_propagation__the_table_tells_what_labels_and_arrivals_say") {
  const Plateaus scene;
  const PropagationResult found = scene.found(cells_of_10_cm());
  const size_t rows = found.regions.at(0)->count();
  REQUIRE(rows == 2);
  for (size_t r = 0; r < rows; ++r) {
    const auto label = static_cast<uint32_t>(r) + 1;
    CHECK(found.regions.require("label").number(r) == label);
    double points = 0, last = 0, largest = -1;
    for (size_t i = 0; i < scene.truth.size(); ++i) {
      if (found.labels[i] != label) continue;
      ++points;
      last = std::max(last, found.arrival_m[i]);
      largest = std::max(largest, scene.deviations[i]);
    }
    CHECK(found.regions.require("points").number(r) == points);
    CHECK(found.regions.require("last_arrival").number(r) == last);
    CHECK(found.regions.require("next_arrival").number(r) > last);
    CHECK(found.regions.require("seed_deviation").number(r) == largest);
    const auto seed = found.regions.require("seed").values<uint64_t>()[r];
    CHECK(found.labels[seed] == label);
    CHECK(found.arrival_m[seed] == 0);
    if (r > 0) CHECK(found.regions.require("points").number(r - 1) >= points);
  }
  for (size_t i = 0; i < scene.truth.size(); ++i)
    CHECK((found.labels[i] == 0) == std::isnan(found.arrival_m[i]));
}

TEST_CASE("segment_by_propagation__min_points_and_minimum_seed_leave_regions_out") {
  const Plateaus scene;
  PropagationSettings set = cells_of_10_cm();
  set.min_points = 400;  // a disc of 0.4 m, or more, has 500 points; the other one 200 at most
  const PropagationResult large = scene.found(set);
  CHECK(large.regions.at(0)->count() == 1);
  CHECK(std::count(large.labels.begin(), large.labels.end(), 2u) == 0);
  set = cells_of_10_cm();
  set.minimum_seed = 1.2;  // the small plateau alone is so high
  const PropagationResult high = scene.found(set);
  for (size_t i = 0; i < scene.truth.size(); ++i)
    if (scene.truth[i] > 0) CHECK((high.labels[i] != 0) == (scene.truth[i] == 2));
  set.minimum_seed = 0;  // two means of the deviations: half way between 0 and 1.04
  CHECK(scene.found(set).minimum_seed == doctest::Approx(0.52).epsilon(0.05).scale(0));
  CHECK(high.minimum_seed == 1.2);
}

TEST_CASE("segment_by_propagation__points_without_either_value_are_in_no_region") {
  Plateaus scene;
  for (size_t i = 0; i < scene.truth.size(); i += 3)
    (i % 2 == 0 ? scene.deviations : scene.gradients)[i] = kNaN;
  const PropagationResult found = scene.found(cells_of_10_cm());
  size_t labelled = 0;
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    if (i % 3 == 0) CHECK(found.labels[i] == 0);
    else labelled += scene.truth[i] > 0 && found.labels[i] != 0;
  }
  CHECK(labelled > 200);
  const auto seed = found.regions.require("seed").values<uint64_t>()[0];
  CHECK(found.labels[seed] == 1);
  CHECK(scene.deviations[seed] == found.regions.require("seed_deviation").number(0));
  std::fill(scene.gradients.begin(), scene.gradients.end(), kNaN);
  CHECK(refuses([&] { scene.found(cells_of_10_cm()); }, Status::kInsufficientData,
                "both a deviation and a gradient"));
}
