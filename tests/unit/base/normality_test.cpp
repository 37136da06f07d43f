// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/normality.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.h"

using namespace jalon;

namespace {

struct KnownTest {
  int kind;
  size_t size;
  uint64_t seed;
  double W, p;
};
constexpr KnownTest kBySciPy[] = {
#include "unit/base/shapiro_wilk_table.inc"
};

std::vector<double> uniforms(uint64_t seed, size_t n) {
  std::vector<double> out;
  for (size_t i = 0; i < n; ++i) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    out.push_back((static_cast<double>(seed >> 11) + 0.5) * 0x1.0p-53);
  }
  return out;
}

std::vector<double> normals(uint64_t seed, size_t n) {
  const std::vector<double> u = uniforms(seed, 2 * n);
  std::vector<double> out;
  for (size_t i = 0; i < n; ++i)
    out.push_back(std::sqrt(-2 * std::log(u[2 * i])) *
                  std::cos(2 * std::numbers::pi * u[2 * i + 1]));
  return out;
}

// The kinds of shapiro_wilk_fixture.py.
std::vector<double> sample_of(const KnownTest& test) {
  std::vector<double> s = test.kind == 0 || test.kind == 4 ? normals(test.seed, test.size)
                                                           : uniforms(test.seed, test.size);
  for (size_t i = 0; i < s.size(); ++i) {
    if (test.kind == 2) s[i] = -std::log(s[i]);
    if (test.kind == 3) s[i] = std::floor(10 * s[i]);
    if (test.kind == 4) s[i] = 1e6 + 0.01 * s[i] + (i % 10 == 0 ? 0.03 : 0);
  }
  return s;
}

}  // namespace

TEST_CASE("shapiro_wilk__of_110_samples__agrees_with_scipy") {
  CHECK(std::size(kBySciPy) >= 100);
  double worst_W = 0, worst_p = 0;
  for (const KnownTest& test : kBySciPy) {
    const ShapiroWilk made = shapiro_wilk(sample_of(test));
    CAPTURE(test.kind);
    CAPTURE(test.size);
    CHECK(std::fabs(made.W - test.W) < 1e-6);
    CHECK(std::fabs(made.p - test.p) < 1e-4);
    worst_W = std::max(worst_W, std::fabs(made.W - test.W));
    worst_p = std::max(worst_p, std::fabs(made.p - test.p));
  }
  MESSAGE("FIGURE Shapiro-Wilk against SciPy, ", std::size(kBySciPy), " samples: W within ",
          worst_W, ", p within ", worst_p);
}

TEST_CASE("shapiro_wilk__printed_reports__have_their_p_values") {
  // Reports of XLSTAT in Monnier (2014), figures 5.25 and 5.28: N, W, p.
  CHECK(std::fabs(shapiro_wilk_p(1 - 0.94056, 14) - 0.42555) < 5e-6);
  CHECK(std::fabs(shapiro_wilk_p(1 - 0.98860, 54) - 0.88580) < 2e-4);  // its W is rounded
  // Critical values at 5 %.
  const double critical[][2] = {{10, 0.8445}, {13, 0.8685}, {14, 0.8754}, {20, 0.9044},
                                {30, 0.9303}, {50, 0.9540}, {54, 0.9569}};
  for (const auto& [n, W] : critical)
    CHECK(std::fabs(shapiro_wilk_p(1 - W, static_cast<uint64_t>(n)) - 0.05) < 2e-4);
}

TEST_CASE("shapiro_wilk__moved_and_stretched__stays_the_same") {
  const std::vector<double> sample = normals(7, 40);
  std::vector<double> other;
  for (const double v : sample) other.push_back(6861000 - 0.002 * v);
  CHECK(shapiro_wilk(other).W == doctest::Approx(shapiro_wilk(sample).W).epsilon(1e-8));
}

TEST_CASE("shapiro_wilk__of_normal_samples__rejects_as_often_as_it_says") {
  int rejected = 0;
  for (uint64_t draw = 0; draw < 4000; ++draw)
    rejected += shapiro_wilk(normals(9000 + draw, 14)).p < 0.05;
  CHECK(rejected > 200 - 60);  // 5 %, four standard errors
  CHECK(rejected < 200 + 60);
}

TEST_CASE("shapiro_wilk__too_few_too_many_or_equal_values__are_refused") {
  const auto status = [](const std::vector<double>& values) {
    try {
      shapiro_wilk(values);
    } catch (const Error& error) {
      return error.status();
    }
    return Status::kOk;
  };
  CHECK(status({1, 2}) == Status::kInsufficientData);
  CHECK(status(normals(1, 5001)) == Status::kLimit);
  CHECK(status({3, 3, 3, 3}) == Status::kDegenerate);
  CHECK(status({1, 2, 3}) == Status::kOk);
}

TEST_CASE("sample_statistics__of_a_known_sample__are_those_of_its_formulas") {
  const SampleStatistics s = sample_statistics(std::vector<double>{2, 4, 4, 4, 5, 5, 7, 9});
  CHECK(s.count == 8);
  CHECK(s.mean == doctest::Approx(5));
  CHECK(s.median == 4.5);
  CHECK(s.variance == doctest::Approx(32.0 / 7));
  CHECK(s.deviation == doctest::Approx(std::sqrt(32.0 / 7)));
  CHECK(s.range == 7);
  CHECK(s.quartile_range == doctest::Approx(1.5));
  // scipy.stats.skew and kurtosis with bias=False.
  CHECK(s.skewness == doctest::Approx(0.8184875533567996));
  CHECK(s.kurtosis == doctest::Approx(0.940625));
  CHECK(std::isnan(sample_statistics(std::vector<double>{1, 2}).skewness));
  CHECK(std::isnan(sample_statistics(std::vector<double>{1}).variance));
}
