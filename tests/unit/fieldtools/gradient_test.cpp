// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Gradients along surfaces: linear fields on random planes, distances from a point, and their laws between methods.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "fieldtools/gradient.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// A patch of 1 x 1 m about the origin on the plane across n.
std::vector<Vec3> patch(const Vec3& n, size_t count, uint64_t seed) {
  const Vec3 u = normalized(cross(n, std::fabs(n.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = cross(n, u);
  RandomStream random(seed, 3);
  std::vector<Vec3> out(count);
  for (Vec3& p : out) {
    const double a = random.uniform() - 0.5, b = random.uniform() - 0.5;
    p = u * a + v * b;
  }
  return out;
}

ValuedPoints valued_by(const Cloud& cloud, double (*f)(const Vec3&), Task& task) {
  std::vector<double> values(cloud.size());
  for (size_t i = 0; i < values.size(); ++i) values[i] = f(cloud.point(i));
  return valued_points(cloud, values, task);
}

}  // namespace

TEST_CASE("field_gradients__least_squares__of_a_linear_field_its_part_along_the_plane_exactly") {
  constexpr auto kLinear = [](const Vec3& p) { return 0.3 * p.x - 0.2 * p.y + 0.4 * p.z + 7; };
  const Vec3 slope{0.3, -0.2, 0.4};
  RandomStream random(1, 3);
  Task task;
  for (uint64_t seed = 0; seed < 8; ++seed) {
    const Vec3 n = normalized(Vec3{random.normal(), random.normal(), random.normal()});
    const Cloud cloud = cloud_of(patch(n, 800, seed));
    const ValuedPoints valued = valued_by(cloud, kLinear, task);
    const Vec3 along = slope - dot(slope, n) * n;
    ValuedPoints spoilt = valued_by(cloud, kLinear, task);
    spoilt.values[17] += 5;  // a step that no distance makes: it has no say elsewhere
    const auto others = field_gradients(spoilt, 0.12, GradientMethod::kLeastSquares, true, task);
    for (size_t i = 0; i < others.size(); ++i)
      if (i != 17) CHECK(norm(others[i] - along) < 1e-6);
    for (const Vec3& g : field_gradients(valued, 0.12, GradientMethod::kLeastSquares, true, task))
      CHECK(norm(g - along) < 1e-6);  // the tree's grid turns balls of 0.1 m by some 1e-8
  }
}

TEST_CASE("field_gradients__corrected_is_twice_the_thesis_and_both_scale_with_the_field") {
  const Cloud cloud = cloud_of(patch({0, 0, 1}, 600, 1));
  Task task;
  const auto wave = [](const Vec3& p) { return 0.1 * std::sin(5 * p.x) + 0.2 * p.y * p.y; };
  const ValuedPoints valued = valued_by(cloud, wave, task);
  ValuedPoints tripled = valued_by(cloud, wave, task);
  for (double& v : tripled.values) v = 3 * v + 2;
  const auto half = field_gradients(valued, 0.2, GradientMethod::kThesis, false, task),
             full = field_gradients(valued, 0.2, GradientMethod::kCorrected, false, task),
             steep = field_gradients(tripled, 0.2, GradientMethod::kCorrected, false, task);
  for (size_t i = 0; i < valued.size(); ++i) {
    CHECK(full[i] == 2 * half[i]);
    CHECK(norm(steep[i] - 3 * full[i]) < 1e-12 * (1 + norm(steep[i])) * 100);  // 2 costs 3 digits
  }
}

TEST_CASE("field_gradients__thesis__half_the_slope_where_the_neighbours_stand_around_evenly") {
  std::vector<Vec3> points{{0, 0, 0}};
  for (const double r : {0.25, 0.5})
    for (const double side : {-r, r}) {
      points.push_back({side, 0, 0});
      points.push_back({0, side, 0});
    }
  const Cloud cloud = cloud_of(points);
  Task task;
  const ValuedPoints valued = valued_by(
      cloud, [](const Vec3& p) { return 0.5 * p.x - 0.25 * p.y + 3; }, task);
  const auto found = field_gradients(valued, 0.6, GradientMethod::kThesis, true, task);
  for (size_t i = 0; i < found.size(); ++i)
    if (valued.points[i] == 0) CHECK(norm(found[i] - Vec3{0.25, -0.125, 0}) < 1e-9);
}

TEST_CASE("field_gradients__of_the_distance_from_a_point_one_and_away_from_it") {
  const Cloud cloud = cloud_of(patch({0, 0, 1}, 20000, 2));
  Task task;
  const auto away = [](const Vec3& p) { return norm(p - Vec3{0.1, 0, 0}); };
  const ValuedPoints valued = valued_by(cloud, away, task);
  const auto found = field_gradients(valued, 0.03, GradientMethod::kLeastSquares, true, task);
  for (size_t i = 0; i < valued.size(); ++i) {
    const Vec3 from = cloud.point(valued.points[i]) - Vec3{0.1, 0, 0};
    const double inside = 0.47 - std::max(std::fabs(from.x + 0.1), std::fabs(from.y));
    if (norm(from) < 0.3 || inside < 0) continue;
    // Across the gradient the field bends by d^2 / 2 r: of 56 points within 3 cm, 0.33 % of the slope; six of these.
    CHECK(norm(found[i]) == doctest::Approx(1).epsilon(0.02).scale(0));
    CHECK(dot(found[i], normalized(from)) > 0.98);
  }
}

TEST_CASE("with_gradient__fields_units_and_points_without_a_gradient") {
  std::vector<Vec3> points = patch({0, 0, 1}, 400, 3);
  points.push_back({5, 5, 0});  // alone
  Cloud cloud = cloud_of(points);
  std::vector<double> values;
  for (const Vec3& p : points) values.push_back(0.5 * p.x);
  values[7] = kNaN;
  cloud.fields.set(make_column<double>({"d", ElementType::kFloat64, 1, "m"}, values));
  cloud.fields.set(make_column<double>({"t", ElementType::kFloat64, 1, "s"}, values));
  GradientSettings set;
  set.radius_m = 0.2;
  set.method = GradientMethod::kLeastSquares;
  set.vector_name = "direction";
  Task task;
  const Cloud out = with_gradient(cloud, "d", set, task);
  const Column &size = out.fields.require("gradient"), &direction = out.fields.require("direction");
  CHECK(size.info().unit == "1");
  CHECK(with_gradient(cloud, "t", set, task).fields.require("gradient").info().unit == "");
  for (size_t i = 0; i < points.size(); ++i) {
    const bool none = i == 7 || i == 400;
    CHECK(std::isnan(size.number(i)) == none);
    CHECK(std::isnan(direction.number(i, 2)) == none);
    if (none) continue;
    CHECK(size.number(i) == doctest::Approx(0.5).epsilon(1e-5).scale(0));  // floats
    CHECK(direction.number(i, 0) == doctest::Approx(0.5).epsilon(1e-5).scale(0));
  }
  set.name = "";
  CHECK(refuses([&] { with_gradient(cloud, "d", set, task); }, Status::kInvalidArgument, "name"));
}

// Half of the points lie on one place, so that its ball holds thousands: they are taken together.
TEST_CASE("field_gradients__of_a_pile_of_points_are_what_brute_force_makes_of_each_ball") {
  constexpr size_t kPoints = 14000;
  constexpr double kRadius_m = 0.05;
  std::vector<Vec3> points = patch({0, 0, 1}, kPoints, 4);
  for (size_t i = 0; i < kPoints; i += 2) points[i] = {0.125, -0.0625, 0};
  const Cloud cloud = cloud_of(points);
  RandomStream random(9, 3);
  std::vector<double> values(kPoints);
  for (size_t i = 0; i < kPoints; ++i) values[i] = 0.2 * points[i].x + 0.02 * random.normal();
  Task task;
  const ValuedPoints valued = valued_points(cloud, values, task);
  for (const bool lipschitz : {true, false}) {
    CAPTURE(lipschitz);
    const auto thesis =
        field_gradients(valued, kRadius_m, GradientMethod::kThesis, lipschitz, task);
    const auto fitted =
        field_gradients(valued, kRadius_m, GradientMethod::kLeastSquares, lipschitz, task);
    size_t crowded = 0;
    for (size_t i = 0; i < kPoints; i += 31) {
      const Vec3 p = points[valued.points[i]];
      const double f = valued.values[i];
      Vec3 sum, mean;
      double mean_difference = 0, uu = 0, uv = 0, vv = 0, uf = 0, vf = 0;
      std::vector<std::pair<Vec3, double>> pairs{{{}, 0}};
      for (size_t j = 0; j < kPoints; ++j) {
        const Vec3 d = points[j] - p;
        const double squared = squared_norm(d), difference = values[j] - f;
        if (squared > kRadius_m * kRadius_m || !(squared > 0) ||
            (lipschitz && std::abs(difference) > 1.001 * std::sqrt(squared)))
          continue;
        sum += d * (difference / squared);
        pairs.emplace_back(d, difference);
      }
      crowded += pairs.size() > 4000;
      if (pairs.size() < 10) continue;  // two close points make slopes that rounding changes
      const auto n = static_cast<double>(pairs.size());
      CHECK(norm(thesis[i] - sum / (n - 1)) < 1e-5 * (1 + norm(sum / (n - 1))));
      for (const auto& [d, difference] : pairs) mean += d / n, mean_difference += difference / n;
      for (const auto& [d, difference] : pairs) {
        const Vec3 e = d - mean;
        const double g = difference - mean_difference;
        uu += e.x * e.x, uv += e.x * e.y, vv += e.y * e.y, uf += e.x * g, vf += e.y * g;
      }
      const double det = uu * vv - uv * uv;
      const Vec3 slope{(vv * uf - uv * vf) / det, (uu * vf - uv * uf) / det, 0};
      CHECK(norm(fitted[i] - slope) < 1e-5 * (1 + norm(slope)));
    }
    if (!lipschitz) CHECK(crowded > 0);
  }
}
