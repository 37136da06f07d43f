// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jalon {

/// P(X <= x) of the standard normal distribution.
double normal_cdf(double x);
/// x with normal_cdf(x) = p; 0 < p < 1.
double normal_quantile(double p);
/// x with P(X <= x) = p of the chi-square distribution; dof >= 1 (need not be whole), 0 <= p < 1.
double chi_square_quantile(double dof, double p);
/// x with P(X <= x) = p of Student's distribution; dof >= 1 (need not be whole), 0.5 <= p < 1.
double student_quantile(double dof, double p);
/// P(X >= x) of the chi-square distribution, and x with P(X >= x) = q, 0 < q <= 1: without the digits that 1 - p would
/// lose.
double chi_square_tail(double dof, double x);
double chi_square_upper_quantile(double dof, double q);
/// P(X >= x) of the beta distribution; a, b > 0, 0 <= x <= 1.
double beta_tail(double a, double b, double x);

}  // namespace jalon
