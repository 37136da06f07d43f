// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/distributions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace jalon;

TEST_CASE("chi-square quantiles are those of the table of Hartley and Zisserman 2003") {
  constexpr double kTable[4][2] = {{3.84, 6.63}, {5.99, 9.21}, {7.81, 11.34}, {9.49, 13.28}};
  for (int dof = 1; dof <= 4; ++dof) {
    CHECK(std::fabs(chi_square_quantile(dof, 0.95) - kTable[dof - 1][0]) <= 0.005 + 1e-9);
    CHECK(std::fabs(chi_square_quantile(dof, 0.99) - kTable[dof - 1][1]) <= 0.006);
  }
}

TEST_CASE("quantiles invert their distributions") {
  for (const double p : {1e-12, 1e-4, 0.1, 0.5, 0.9, 0.9999}) {
    CHECK(normal_cdf(normal_quantile(p)) == doctest::Approx(p).epsilon(1e-12).scale(0));
    // With one degree of freedom chi-square is the square of a normal deviate, with two an exponential.
    const double z = normal_quantile(0.5 + p / 2);
    CHECK(chi_square_quantile(1, p) == doctest::Approx(z * z).epsilon(1e-9));
    CHECK(chi_square_quantile(2, p) == doctest::Approx(-2 * std::log1p(-p)).epsilon(1e-9));
  }
  CHECK(normal_quantile(0.975) == doctest::Approx(1.959963984540054).epsilon(1e-14));
  CHECK(chi_square_quantile(7, 0) == 0);
}

TEST_CASE("student_quantile__agrees_with_the_tables_and_tends_to_the_normal_distribution") {
  // Abramowitz & Stegun (1964), table 26.10; one degree of freedom is Cauchy's distribution, two have a closed form.
  CHECK(student_quantile(1, 0.975) ==
        doctest::Approx(std::tan(0.475 * 3.14159265358979324)).epsilon(1e-12));
  CHECK(student_quantile(2, 0.975) == doctest::Approx(0.95 * std::sqrt(2 / 0.0975)).epsilon(1e-12));
  CHECK(student_quantile(1, 0.9999) == doctest::Approx(3183.0987570987).epsilon(1e-9));
  CHECK(std::fabs(student_quantile(10, 0.975) - 2.228139) < 5e-7);
  CHECK(std::fabs(student_quantile(30, 0.995) - 2.749996) < 5e-7);
  CHECK(std::fabs(student_quantile(120, 0.95) - 1.657651) < 5e-7);
  CHECK(student_quantile(1e9, 0.975) == doctest::Approx(normal_quantile(0.975)).epsilon(1e-8));
  CHECK(student_quantile(5, 0.5) == 0);
}
