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
using Quiet = policies::policy<policies::domain_error<policies::ignore_error>,
                               policies::pole_error<policies::ignore_error>,
                               policies::overflow_error<policies::ignore_error>,
                               policies::evaluation_error<policies::ignore_error>, policies::promote_double<false>>;

}  // namespace

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

double normal_quantile(double p) {
  if (!(p > 0 && p < 1)) fail(Status::kInternal, "normal_quantile: the probability is not within (0, 1)");
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * p, Quiet());
}

double chi_square_quantile(double dof, double p) {
  if (!(dof >= 1 && p >= 0 && p < 1))
    fail(Status::kInternal, "chi_square_quantile: dof below 1 or the probability not within [0, 1)");
  return 2 * boost::math::gamma_p_inv(dof / 2, p, Quiet());
}

}  // namespace jalon
