// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fieldtools/field_arithmetic.h"
#include "fieldtools/field_values.h"
#include "fieldtools/gradient.h"
#include "fieldtools/smoothing.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

/// A plane that is askew in space, 10 x 10 m, with a field of slope (0.6, 0) in its own directions.
struct Slope {
  Cloud cloud;
  std::vector<Vec2> places;
};
Slope slope(size_t n, uint64_t seed) {
  RandomStream random(seed, 0);
  const Vec3 u = normalized({1, 0.4, 0.3}), v = normalized(cross({0.2, -0.3, 1}, u));
  std::vector<Vec3> points(n);
  std::vector<double> field(n);
  Slope out;
  for (size_t i = 0; i < n; ++i) {
    const Vec2 at{10 * random.uniform(), 10 * random.uniform()};
    points[i] = u * at.u + v * at.v;
    field[i] = 0.6 * at.u + 2;
    out.places.push_back(at);
  }
  out.cloud = with_field<double>(cloud_of(points), "f", "m", "", field);
  return out;
}

std::span<const float> floats(const Cloud& cloud, const char* name) {
  return cloud.fields.require(name).values<float>();
}
std::span<const double> doubles(const Cloud& cloud, const char* name) {
  return cloud.fields.require(name).values<double>();
}

TEST_CASE("gradient__of_a_linear_field__half_of_it_by_the_thesis_and_all_of_it_corrected") {
  const Slope s = slope(50000, 1);
  const double expected[] = {0.5, 1.0, 1.0};
  const char* methods[] = {"thesis", "corrected", "least_squares"};
  for (size_t m = 0; m < 3; ++m) {
    auto set = settings_by<GradientSettings>(gradient_rows(), {{"method", methods[m]}});
    set.radius_m = 0.25;
    set.vector_name = "g";
    Task task;
    const Cloud out = with_gradient(s.cloud, "f", set, task);
    double sum = 0, along = 0, border = 0;
    size_t n = 0, borders = 0;
    const Vec3 u = normalized({1, 0.4, 0.3});
    for (size_t i = 0; i < out.size(); ++i) {
      const Vec2& at = s.places[i];
      const bool inside = std::min({at.u, at.v, 10 - at.u, 10 - at.v}) > 0.25;
      const auto g = floats(out, "g").subspan(3 * i, 3);
      if (inside) {
        sum += floats(out, "gradient")[i];
        along += dot(Vec3{g[0], g[1], g[2]}, u);
        ++n;
      } else {
        border += floats(out, "gradient")[i];
        ++borders;
      }
    }
    const double norm_mean = sum / static_cast<double>(n) / 0.6,
                 mean = along / static_cast<double>(n) / 0.6;
    MESSAGE("FIGURE gradient of a linear field, ", std::string(methods[m]), ": ", mean,
            " along it (", expected[m], " +- 2 %), mean norm ", norm_mean, ", at the border ",
            border / static_cast<double>(borders) / 0.6);
    CHECK(std::fabs(mean / expected[m] - 1) < 0.02);
    if (m == 2) CHECK(std::fabs(border / static_cast<double>(borders) / 0.6 - 1) < 1e-5);
  }
}

TEST_CASE("gradient__pairs_that_no_distance_field_can_have__left_out") {
  Slope s = slope(20000, 2);
  std::vector<double> f(doubles(s.cloud, "f").begin(), doubles(s.cloud, "f").end());
  for (size_t i = 0; i < f.size(); i += 50) f[i] += 5;  // outliers
  const Cloud bad = with_field<double>(s.cloud, "f", "m", "", f);
  GradientSettings set;
  set.method = GradientMethod::kLeastSquares;
  Task task;
  const Cloud with = with_gradient(bad, "f", set, task);
  set.distance_field = false;
  const Cloud without = with_gradient(bad, "f", set, task);
  double worst = 0, worst_without = 0;
  for (size_t i = 0; i < f.size(); ++i) {
    if (i % 50 == 0) continue;
    worst = std::max(worst, std::fabs(double{floats(with, "gradient")[i]} - 0.6));
    worst_without =
        std::max(worst_without, std::fabs(double{floats(without, "gradient")[i]} - 0.6));
  }
  CHECK(worst < 1e-4);
  CHECK(worst_without > 1);
}

TEST_CASE("gradient__lonely_points_and_missing_values__nan") {
  const Cloud cloud =
      with_field<double>(cloud_of({{0, 0, 0}, {1, 0, 0}, {1.1, 0, 0}, {1.2, 0, 0}}), "f", "m", "",
                         std::vector<double>{1, 2, std::nan(""), 2.1});
  GradientSettings set;
  set.radius_m = 0.15;
  Task task;
  const Cloud out = with_gradient(cloud, "f", set, task);
  for (int i = 0; i < 4; ++i) CHECK(std::isnan(floats(out, "gradient")[static_cast<size_t>(i)]));
  set.radius_m = 0.25;
  CHECK(floats(with_gradient(cloud, "f", set, task), "gradient")[1] == doctest::Approx(2 * 0.5));
  set.radius_m = 0;
  CHECK(status_of([&] { with_gradient(cloud, "f", set, task); }) == Status::kInsufficientData);
  CHECK(status_of([&] { with_gradient(cloud, "no such", set, task); }) == Status::kNotFound);
}

TEST_CASE("field_filter__equals_brute_force") {
  const auto points = random_points(1500, 4, 3);
  RandomStream random(3, 5);
  std::vector<double> f(points.size());
  for (double& v : f) v = random.uniform() < 0.1 ? std::nan("") : random.normal();
  const Cloud cloud = with_field<double>(cloud_of(points), "f", "m", "", f);
  Task task;
  for (const char* method : {"gaussian", "mean", "median", "minimum", "maximum"}) {
    auto set = settings_by<FieldFilterSettings>(field_filter_rows(), {{"method", method}});
    set.radius_m = 0.5;
    set.sigma_m = 0.2;
    set.cut_sigmas = 2.5;
    const Cloud out = with_filtered_field(cloud, "f", set, task);
    for (size_t i = 0; i < points.size(); i += 7) {
      const double found = doubles(out, "filtered")[i];
      if (std::isnan(f[i])) {
        CHECK(std::isnan(found));
        continue;
      }
      std::vector<double> around;
      double weights = 0, sum = 0;
      for (size_t j = 0; j < points.size(); ++j) {
        const double d2 = squared_norm(points[j] - points[i]);
        if (d2 > 0.25 || std::isnan(f[j])) continue;
        around.push_back(f[j]);
        weights += std::exp(-d2 / 0.08);
        sum += std::exp(-d2 / 0.08) * f[j];
      }
      std::sort(around.begin(), around.end());
      const size_t n = around.size();
      const double total = std::accumulate(around.begin(), around.end(), 0.0);
      const std::string m = method;
      const double expected = m == "gaussian"  ? sum / weights
                              : m == "minimum" ? around.front()
                              : m == "maximum" ? around.back()
                              : m == "median"  ? 0.5 * (around[(n - 1) / 2] + around[n / 2])
                                               : total / static_cast<double>(n);
      CHECK(found == doctest::Approx(expected).epsilon(1e-6));
    }
  }
}

TEST_CASE("field_filter__gaussian_of_a_linear_field__the_field_inside") {
  const Slope s = slope(50000, 4);
  Task task;
  const Cloud out = with_filtered_field(s.cloud, "f", FieldFilterSettings{}, task);
  double worst = 0;
  for (size_t i = 0; i < out.size(); ++i) {
    const Vec2& at = s.places[i];
    if (std::min({at.u, at.v, 10 - at.u, 10 - at.v}) > 0.5)
      worst = std::max(worst, std::fabs(doubles(out, "filtered")[i] - doubles(out, "f")[i]));
  }
  CHECK(worst < 0.05);
}

TEST_CASE("field_arithmetic__every_operation") {
  const std::vector<double> a{4, -1, 0, std::nan("")}, b{2, 0, 0, 1};
  Cloud cloud =
      with_field<double>(cloud_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}), "a", "m", "", a);
  cloud = with_field<double>(cloud, "b", "m", "", b);
  Task task;
  const auto run = [&](const char* operation, const char* other) {
    auto set =
        settings_by<FieldArithmeticSettings>(field_arithmetic_rows(), {{"operation", operation}});
    set.constant = 3;
    const Cloud out = with_computed_field(cloud, "a", other, set, task);
    return std::vector<double>(doubles(out, "computed").begin(), doubles(out, "computed").end());
  };
  CHECK(run("add", "b")[0] == 6);
  CHECK(run("add", "")[0] == 7);
  CHECK(run("subtract", "b")[1] == -1);
  CHECK(run("multiply", "b")[0] == 8);
  CHECK(run("divide", "b")[0] == 2);
  CHECK(std::isnan(run("divide", "b")[1]));
  CHECK(run("minimum", "b")[0] == 2);
  CHECK(run("maximum", "b")[1] == 0);
  CHECK(std::isnan(run("maximum", "b")[3]));
  CHECK(run("power", "b")[0] == 16);
  CHECK(run("absolute", "")[1] == 1);
  CHECK(run("negate", "")[0] == -4);
  CHECK(run("sqrt", "")[0] == 2);
  CHECK(std::isnan(run("sqrt", "")[1]));
  CHECK(run("square", "")[0] == 16);
  CHECK(run("exp", "")[2] == 1);
  CHECK(run("log", "")[0] == doctest::Approx(std::log(4.0)));
  CHECK(std::isnan(run("log", "")[2]));
  CHECK(run("log10", "")[0] == doctest::Approx(std::log10(4.0)));
  CHECK(run("dot", "b")[0] == 8);
}

TEST_CASE("field_arithmetic__vectors__dot_and_norm") {
  const std::vector<float> v{3, 4, 0, 1, 2, 2};
  Cloud cloud = cloud_of({{0, 0, 0}, {1, 0, 0}});
  cloud.fields.set(make_column<float>({"v", ElementType::kFloat32, 3, "m", ""}, v));
  Task task;
  FieldArithmeticSettings set;
  set.operation = FieldArithmeticSettings::Operation::kNorm;
  CHECK(doubles(with_computed_field(cloud, "v", "", set, task), "computed")[0] == 5);
  set.operation = FieldArithmeticSettings::Operation::kDot;
  CHECK(doubles(with_computed_field(cloud, "v", "v", set, task), "computed")[1] == 9);
  set.operation = FieldArithmeticSettings::Operation::kMultiply;
  const Cloud out = with_computed_field(cloud, "v", "", set, task);
  CHECK(out.fields.require("computed").info().components == 3);
}

TEST_CASE("field_tools__threads_and_a_shift_by_whole_metres__the_same_bits") {
  const auto points = random_points(20000, 8, 6);
  RandomStream random(6, 1);
  std::vector<double> f(points.size());
  for (double& v : f) v = random.uniform() < 0.05 ? std::nan("") : random.uniform();
  const Cloud near = with_field<double>(cloud_of(points), "f", "m", "", f);
  const Cloud far = with_field<double>(cloud_of(shifted(points, kFar)), "f", "m", "", f);
  Task one(threads(1)), seven(threads(7));
  for (const char* method : {"corrected", "least_squares"}) {
    auto set = settings_by<GradientSettings>(gradient_rows(), {{"method", method}});
    set.distance_field = false;
    const Cloud a = with_gradient(near, "f", set, one);
    CHECK(same_bits(a, with_gradient(near, "f", set, seven)));
    CHECK(same_fields(a, with_gradient(far, "f", set, one)));
  }
  for (const char* method : {"gaussian", "mean", "median"}) {
    auto set = settings_by<FieldFilterSettings>(field_filter_rows(), {{"method", method}});
    const Cloud a = with_filtered_field(near, "f", set, one);
    CHECK(same_bits(a, with_filtered_field(near, "f", set, seven)));
    CHECK(same_fields(a, with_filtered_field(far, "f", set, one)));
  }
}

}  // namespace
}  // namespace jalon
