// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/distributions.h"

#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace jalon {

namespace {

// Errors come back as NaN or infinity and are not thrown; long double gives nothing that a double could keep.
namespace policies = boost::math::policies;
using Quiet = policies::policy<
    policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
    policies::overflow_error<policies::ignore_error>,
    policies::evaluation_error<policies::ignore_error>, policies::promote_double<false>>;

// Continued fraction of the incomplete beta function (Abramowitz & Stegun 1964, 26.5.8) by the method of Lentz (1976).
double beta_fraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300, kEnough = 1e-16;
  constexpr int kMostTerms = 500;
  double c = 1, d = 1 - (a + b) * x / (a + 1), value = 1;
  d = 1 / (std::fabs(d) < kTiny ? kTiny : d);
  value = d;
  for (int m = 1; m < kMostTerms; ++m) {
    double change = 1;
    for (const double term : {m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
                              -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))}) {
      d = 1 + term * d;
      c = 1 + term / c;
      d = 1 / (std::fabs(d) < kTiny ? kTiny : d);
      c = std::fabs(c) < kTiny ? kTiny : c;
      change = c * d;
      value *= change;
    }
    if (std::fabs(change - 1) < kEnough) break;
  }
  return value;
}

// P(X > x) of Student's distribution, x > 0: half of I_w(dof / 2, 1 / 2) at w = dof / (dof + x^2); density: 1 / B.
double student_tail(double x, double dof, double density) {
  const double a = dof / 2, b = 0.5, w = dof / (dof + x * x), rest = x * x / (dof + x * x);
  const double front = density * std::pow(w, a) * std::sqrt(rest);
  return w < (a + 1) / (a + b + 2) ? 0.5 * front * beta_fraction(a, b, w) / a
                                   : 0.5 - 0.5 * front * beta_fraction(b, a, rest) / b;
}

}  // namespace

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

double normal_quantile(double p) {
  if (!(p > 0 && p < 1))
    fail(Status::kInternal, "normal_quantile: the probability is not within (0, 1)");
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * p, Quiet());
}

double chi_square_quantile(double dof, double p) {
  if (!(dof >= 1 && p >= 0 && p < 1))
    fail(Status::kInternal,
         "chi_square_quantile: dof below 1 or the probability not within [0, 1)");
  return 2 * boost::math::gamma_p_inv(dof / 2, p, Quiet());
}

double student_quantile(double dof, double p) {
  if (!(dof >= 1 && p >= 0.5 && p < 1))
    fail(Status::kInternal, "student_quantile: dof below 1 or the probability not within [0.5, 1)");
  if (p == 0.5) return 0;
  // 1 / B(dof / 2, 1 / 2)
  const double density =
      1 / (std::sqrt(std::numbers::pi) * boost::math::tgamma_delta_ratio(dof / 2, 0.5, Quiet()));
  // Newton's method from the normal quantile, which lies below: the distribution is concave there, so the steps rise to
  // the quantile and never pass it.
  double x = normal_quantile(p);
  constexpr int kMostSteps = 100;  // far out each step doubles x
  for (int step = 0; step < kMostSteps; ++step) {
    const double slope = density / std::sqrt(dof) * std::pow(1 + x * x / dof, -0.5 * (dof + 1));
    const double change = (student_tail(x, dof, density) - (1 - p)) / slope;
    x += change;
    if (!(std::fabs(change) > 1e-14 * x)) break;
  }
  return x;
}

double chi_square_tail(double dof, double x) {
  if (!(dof >= 1)) fail(Status::kInternal, "chi_square_tail: dof below 1");
  return x > 0 ? boost::math::gamma_q(dof / 2, x / 2, Quiet()) : 1;
}

double chi_square_upper_quantile(double dof, double q) {
  if (!(dof >= 1 && q > 0 && q <= 1))
    fail(Status::kInternal,
         "chi_square_upper_quantile: dof below 1 or the probability not within (0, 1]");
  return 2 * boost::math::gamma_q_inv(dof / 2, q, Quiet());
}

double beta_tail(double a, double b, double x) {
  if (!(a > 0 && b > 0 && x >= 0 && x <= 1))
    fail(Status::kInternal, "beta_tail: a, b or x out of range");
  if (x == 0 || x == 1) return x == 0 ? 1 : 0;
  // Abramowitz & Stegun 1964, 26.5.8: the fraction converges below the mean, its mirror image above.
  const auto log_gamma = [](double z) { return boost::math::lgamma(z, Quiet()); };
  const double front = std::exp(a * std::log(x) + b * std::log1p(-x) + log_gamma(a + b) -
                                log_gamma(a) - log_gamma(b));
  return x < (a + 1) / (a + b + 2) ? 1 - front * beta_fraction(a, b, x) / a
                                   : front * beta_fraction(b, a, 1 - x) / b;
}

}  // namespace jalon
