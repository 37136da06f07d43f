// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Field and angular steps of a scanner, from lattices that are known.
#include "compare/visibility/depth_steps.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSingle = 5e-7;  // angles up to pi in single precision

Seen seen_at(double h, double v) {
  if (h >= std::numbers::pi) h -= kTurn;
  return {static_cast<float>(h), static_cast<float>(v), 5.0f};
}

/// A lattice from there and -0.2 on, its points in any order.
std::vector<Seen> shuffled_lattice(int columns, int rows, double h_step, double v_step,
                                   double from = 0.3) {
  std::vector<Seen> out;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) out.push_back(seen_at(from + i * h_step, -0.2 + j * v_step));
  RandomStream random(71, 0);
  for (size_t i = out.size(); i > 1; --i) std::swap(out[i - 1], out[random.below(i)]);
  return out;
}

AngularSteps steps_of(const std::vector<Seen>& points) {
  Task task;
  return angular_steps(points, angular_field(points, task), task);
}

}  // namespace

TEST_CASE("angular_field__is_what_was_looked_at_wherever_it_lies_on_the_circle") {
  Task task;
  for (const double from : {-3.1, -1.0, 0.0, 1.3, 2.9}) {
    RandomStream random(72, 0);
    std::vector<Seen> points{seen_at(from + 1.2, 0.4), seen_at(from, -0.3)};
    for (int k = 0; k < 300; ++k) {
      const double aside = 1.2 * random.uniform(), up = 0.7 * random.uniform() - 0.3;
      points.push_back(seen_at(from + aside, up));
    }
    const AngularField field = angular_field(points, task);
    CHECK_FALSE(field.is_closed);
    CHECK(std::fabs(field.horizontal_from_rad - from) < kSingle);
    CHECK(std::fabs(field.horizontal_extent_rad - 1.2) < 2 * kSingle);
    CHECK(std::fabs(field.vertical_from_rad + 0.3) < kSingle);
    CHECK(std::fabs(field.vertical_extent_rad - 0.7) < 2 * kSingle);
  }
}

TEST_CASE("angular_field__is_closed_over_a_narrow_gap_and_open_over_a_wide_one") {
  const auto circle_without = [](double gap) {
    std::vector<Seen> points;
    for (int k = 0; k < 628; ++k)
      if (const double h = 0.01 * k; h <= 1 || h >= 1 + gap) points.push_back(seen_at(h, 0.1));
    Task task;
    return angular_field(points, task);
  };
  CHECK(circle_without(0).is_closed);
  CHECK(circle_without(0.04).is_closed);  // a mast
  const AngularField open = circle_without(0.2);
  CHECK_FALSE(open.is_closed);
  CHECK(std::fabs(open.horizontal_from_rad - 1.2) < kSingle);
  CHECK(std::fabs(open.horizontal_extent_rad - (kTurn - 0.2)) < 2 * kSingle);
  CHECK(open.vertical_extent_rad == 0);
}

TEST_CASE("angular_steps__are_those_of_the_lattice_also_with_a_window_scanned_finer") {
  for (const auto& [h, v] : {std::pair{0.006, 0.006}, {0.004, 0.015}, {0.012, 0.003}}) {
    // Behind the scanner angles jump.
    const AngularSteps behind = steps_of(shuffled_lattice(90, 80, h, v, 2.9));
    CHECK(behind.horizontal_rad == doctest::Approx(h).epsilon(0.01).scale(0));
    CHECK(behind.vertical_rad == doctest::Approx(v).epsilon(0.01).scale(0));
    auto points = shuffled_lattice(90, 80, h, v);
    // Two fifths of the field once more, four times as dense each way: six times as many points.
    const auto fine = shuffled_lattice(144, 320, h / 4, v / 4);
    for (int k = 0; k < 2; ++k) {
      const AngularSteps found = steps_of(points);
      CHECK(found.horizontal_rad == doctest::Approx(h).epsilon(0.01).scale(0));
      CHECK(found.vertical_rad == doctest::Approx(v).epsilon(0.01).scale(0));
      points.insert(points.end(), fine.begin(), fine.end());
    }
  }
}

TEST_CASE("angular_steps__of_scattered_points_rows_and_single_points_can_be_used") {
  RandomStream random(73, 0);
  std::vector<Seen> scattered;
  for (int k = 0; k < 10000; ++k) {
    const double aside = random.uniform(), up = 0.5 * random.uniform();
    scattered.push_back(seen_at(aside, up));
  }
  const AngularSteps steps = steps_of(scattered);
  // As far as its distances and its density may disagree: three times the area a point.
  CHECK(steps.horizontal_rad * steps.vertical_rad > 0.5e-4 / 3.1);
  CHECK(steps.horizontal_rad * steps.vertical_rad < 0.5e-4 * 3.1);
  const AngularSteps row = steps_of(shuffled_lattice(200, 1, 0.01, 1));
  CHECK(row.horizontal_rad == doctest::Approx(0.01).epsilon(0.01).scale(0));
  CHECK(row.vertical_rad > 0);
  for (const size_t n : {size_t{1}, size_t{50}}) {
    const AngularSteps same = steps_of(std::vector<Seen>(n, seen_at(1, 0.5)));
    CHECK(same.horizontal_rad > 0);
    CHECK(same.vertical_rad > 0);
  }
}
