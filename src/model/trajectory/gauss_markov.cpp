// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/gauss_markov.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/random.h"

namespace jalon {

double GaussMarkov::covariance(size_t i, size_t j) const {
  if (i > j) std::swap(i, j);
  double value = sigmas_m[i] * sigmas_m[i];
  for (size_t k = i; k < j; ++k) value *= factors[k];
  return value;
}

GaussMarkov gauss_markov(std::span<const double> times_s, std::span<const double> sigmas_m,
                         std::span<const double> velocity_sigmas_m_s) {
  GaussMarkov chain;
  chain.sigmas_m.assign(sigmas_m.begin(), sigmas_m.end());
  for (size_t i = 0; i + 1 < sigmas_m.size(); ++i) {
    const double drift = (times_s[i + 1] - times_s[i]) * velocity_sigmas_m_s[i];
    const double n = sigmas_m[i + 1] / std::hypot(sigmas_m[i], drift);
    chain.factors.push_back(n);
    chain.innovations.push_back(n * n * drift * drift);
  }
  return chain;
}

TridiagonalInformation information_of(const GaussMarkov& chain) {
  TridiagonalInformation made;
  made.diagonal.assign(chain.size(), 0);
  made.diagonal[0] = 1 / (chain.sigmas_m[0] * chain.sigmas_m[0]);
  for (size_t i = 0; i + 1 < chain.size(); ++i) {
    const double n = chain.factors[i], q = chain.innovations[i];
    made.diagonal[i] += n * n / q;
    made.diagonal[i + 1] += 1 / q;
    made.beside.push_back(-n / q);
  }
  return made;
}

std::vector<double> drawn(const GaussMarkov& chain, uint64_t seed, uint64_t stream) {
  RandomStream random(seed, stream);
  std::vector<double> errors;
  errors.reserve(chain.size());
  errors.push_back(chain.sigmas_m[0] * random.normal());
  for (size_t i = 0; i + 1 < chain.size(); ++i)
    errors.push_back(chain.factors[i] * errors[i] +
                     std::sqrt(chain.innovations[i]) * random.normal());
  return errors;
}

GaussMarkov position_prior(const Trajectory& trajectory, int axis) {
  if (trajectory.position_sigmas_m.empty())
    fail(Status::kInvalidArgument,
         "the trajectory has no position sigmas: without them nothing is known of its errors");
  std::vector<double> sigmas, velocities(trajectory.size(), kDriftSigma_m_s);
  for (const Vec3& s : trajectory.position_sigmas_m) sigmas.push_back(s[axis]);
  for (size_t i = 0; i < trajectory.velocity_sigmas_m_s.size(); ++i)
    velocities[i] = trajectory.velocity_sigmas_m_s[i][axis];
  return gauss_markov(trajectory.times_s, sigmas, velocities);
}

Trajectory perturbed(const Trajectory& trajectory, uint64_t seed) {
  const std::vector<double> x = drawn(position_prior(trajectory, 0), seed, 0),
                            y = drawn(position_prior(trajectory, 1), seed, 1);
  Trajectory out = trajectory;
  for (size_t i = 0; i < out.size(); ++i) {
    out.positions[i].x += x[i];
    out.positions[i].y += y[i];
  }
  return out;
}

}  // namespace jalon
