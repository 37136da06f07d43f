// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/field_normality.h"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

#include "base/error.h"
#include "base/numbers.h"
#include "base/random.h"

using namespace jalon;

namespace {

std::vector<double> drawn_values(size_t n, bool are_normal) {
  RandomStream random(3, 0);
  std::vector<double> out;
  for (size_t i = 0; i < n; ++i) out.push_back(are_normal ? random.normal() : random.uniform());
  return out;
}

}  // namespace

TEST_CASE("normality__of_a_field__tells_normal_from_even_and_leaves_out_what_is_not_finite") {
  std::vector<double> values = drawn_values(500, true);
  const NormalityReport clean = test_normality(values, {});
  CHECK(clean.is_normal);
  values.push_back(kNaN);
  values.insert(values.begin(), std::numeric_limits<double>::infinity());
  const NormalityReport report = test_normality(values, {});
  CHECK(report.test.W == clean.test.W);
  CHECK(report.statistics.count == 500);
  CHECK(!test_normality(drawn_values(500, false), {}).is_normal);
  NormalitySettings strict;
  strict.alpha = clean.test.p + 0.01;
  CHECK(!test_normality(values, strict).is_normal);
}

TEST_CASE("normality__of_many_values__tests_a_draw_of_them_and_describes_all") {
  const std::vector<double> values = drawn_values(60000, true);
  const NormalityReport report = test_normality(values, {});
  CHECK(report.tested == 5000);
  CHECK(report.statistics.count == 60000);
  CHECK(report.statistics.deviation == doctest::Approx(1).epsilon(0.02));
  CHECK(test_normality(values, {}).test.W == report.test.W);
  NormalitySettings other;
  other.seed = 2;
  CHECK(test_normality(values, other).test.W != report.test.W);
  CHECK_THROWS_AS(test_normality(std::vector<double>(10, kNaN), {}), Error);
}
