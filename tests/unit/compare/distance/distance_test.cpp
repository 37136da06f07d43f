// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "base/error.h"
#include "unit/compare/distance_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double distance_by_force(const Cloud& reference, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < reference.size(); ++i)
    least = std::min(least, squared_norm(reference.point(i) - p));
  return std::sqrt(least);
}

double largest_by_force(const Cloud& from, const Cloud& to) {
  double largest = 0;
  for (size_t i = 0; i < from.size(); ++i)
    largest = std::max(largest, distance_by_force(to, from.point(i)));
  return largest;
}

}  // namespace

TEST_CASE("distance__equals_brute_force_and_its_differences_add_up_to_it") {
  const auto reference = cloud_of(random_square(3000, 10, 0, 1, 0.05));
  const auto other = cloud_of(random_square(2000, 12, 0.1, 2, 0.05));
  DistanceSettings settings;
  settings.max_distance_m = 0.5;
  settings.differences = true;
  const Comparison made = compared(reference, other, settings);
  const auto distance = made.points.require("distance").values<double>();
  const auto status = made.points.require("status").values<uint8_t>();
  const auto nearest = made.points.require("nearest").values<uint32_t>();
  size_t without = 0;
  for (size_t i = 0; i < other->size(); ++i) {
    const double expected = distance_by_force(*reference, other->point(i));
    if (expected > 0.5) {
      REQUIRE(std::isnan(distance[i]));
      REQUIRE(std::isnan(made.points.require("difference_x").number(i)));
      REQUIRE(status[i] == static_cast<uint8_t>(CompareStatus::kNothingNear));
      ++without;
      continue;
    }
    REQUIRE(distance[i] == doctest::Approx(expected).epsilon(1e-12));
    const Vec3 d{made.points.require("difference_x").number(i),
                 made.points.require("difference_y").number(i),
                 made.points.require("difference_z").number(i)};
    REQUIRE(d == other->point(i) - reference->point(nearest[i]));
    REQUIRE(norm(d) == doctest::Approx(distance[i]).epsilon(1e-12));
  }
  CHECK(without > 300);
  CHECK(summary(made, "nothing_near") == static_cast<double>(without));
}

TEST_CASE("distance__hausdorff_distances_equal_brute_force_whatever_the_greatest_distance") {
  const auto reference = cloud_of(random_square(1500, 10, 0, 3)),
             other = cloud_of(random_square(900, 8, 2, 4));
  DistanceSettings settings;
  settings.hausdorff = true;
  settings.max_distance_m = 1;
  const Comparison made = compared(reference, other, settings);
  const double forward = largest_by_force(*other, *reference),
               reverse = largest_by_force(*reference, *other);
  CHECK(summary(made, "hausdorff_forward") == doctest::Approx(forward).epsilon(1e-12));
  CHECK(summary(made, "hausdorff_reverse") == doctest::Approx(reverse).epsilon(1e-12));
  CHECK(summary(made, "hausdorff") ==
        std::max(summary(made, "hausdorff_forward"), summary(made, "hausdorff_reverse")));
}

// Spec 9 (6) and T1: two random samplings of one square of 100 mm; queries away from its border.
TEST_CASE("distance__sampling_error_on_a_plane_follows_the_theory_and_is_predicted") {
  struct {
    size_t reference;
    int runs;
  } const rows[] = {{10000, 8}, {50000, 6}, {200000, 6}};
  for (const auto& row : rows) {
    const double lambda = static_cast<double>(row.reference) / (0.1 * 0.1);
    const double theory = 1 / std::sqrt(std::numbers::pi * lambda);
    double squares = 0, count = 0, roots = 0, predicted = 0;
    for (int run = 0; run < row.runs; ++run) {
      const auto seed = static_cast<uint64_t>(run);
      const auto reference = cloud_of(random_square(row.reference, 0.1, 0, 2 * seed + 10));
      const auto all = random_square(10000, 0.1, 0, 2 * seed + 11);
      std::vector<double> inner;
      for (size_t i = 0; i < all.size(); i += 3)
        if (std::min(all[i], all[i + 1]) > 0.003 && std::max(all[i], all[i + 1]) < 0.097)
          inner.insert(inner.end(), {all[i], all[i + 1], all[i + 2]});
      DistanceSettings settings;
      settings.sampling_error = true;
      const Comparison made = compared(reference, cloud_of(inner), settings);
      const double n = summary(made, "compared"), rms = summary(made, "rms");
      squares += n * rms * rms;
      roots += n * summary(made, "mean");
      count += n;
      predicted += summary(made, "sampling_rms") / row.runs;
    }
    const double rms = std::sqrt(squares / count), mean = roots / count;
    MESSAGE("FIGURE S1 N = ", row.reference, ": RMS ", 1000 * rms, " mm, theory ", 1000 * theory,
            ", ratio ", rms / theory, "; mean ratio ", mean * 2 * std::sqrt(lambda),
            "; predicted ratio ", predicted / theory);
    CHECK(std::fabs(rms / theory - 1) < 0.01);
    CHECK(std::fabs(mean * 2 * std::sqrt(lambda) - 1) < 0.01);
    CHECK(std::fabs(predicted / theory - 1) < 0.01);
  }
}

TEST_CASE("distance__one_point_equal_points_and_empty_overlap_have_a_value_or_a_status") {
  const auto one = cloud_of({1, 2, 3}), square = cloud_of(random_square(200, 1, 0, 5));
  std::vector<double> equal;
  for (int i = 0; i < 5000; ++i) equal.insert(equal.end(), {0.5, 0.5, 7});
  DistanceSettings settings;
  settings.sampling_error = true;
  settings.hausdorff = true;
  for (const auto& [reference, other] : {std::pair{one, square},
                                         {square, one},
                                         {one, one},
                                         {cloud_of(equal), square},
                                         {square, cloud_of(equal)},
                                         {cloud_of(equal), cloud_of(equal)}}) {
    const Comparison made = compared(reference, other, settings);
    CHECK(summary(made, "compared") == static_cast<double>(other->size()));
    CHECK(summary(made, "hausdorff") == summary(compared(other, reference, settings), "hausdorff"));
  }
  CHECK(std::isnan(summary(compared(one, square, settings), "sampling_rms")));
  settings.max_distance_m = 0.5;
  const Comparison nothing = compared(one, square, settings);
  CHECK(summary(nothing, "nothing_near") == 200);
  CHECK(std::isnan(summary(nothing, "mean")));
  const auto empty = cloud_of({});
  CHECK_THROWS_AS(compared(empty, one, settings), Error);
  CHECK_THROWS_AS(compared(one, empty, settings), Error);
}
