// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/normal.h"

#include <cmath>

#include "base/parallel.h"
#include "registration/symmetric_eigen6.h"

namespace jalon {

namespace {

constexpr size_t kNormalGrain = 1 << 13;
constexpr size_t kResidualSample =
    1 << 15;  // of either side: a median of so many is within 1 % of that of all
constexpr double kNormalLeastShare =
    1e-9;  // of the strongest direction: what rounding leaves of a noise-free plane

void add_plane_pair(const IcpPair& pair, double w, const IcpFrame& frame, IcpSums& sums) {
  const Vec3 arm = (pair.place - frame.centre) / frame.extent_m, turn = cross(arm, pair.normal);
  const double j[6] = {turn.x, turn.y, turn.z, pair.normal.x, pair.normal.y, pair.normal.z};
  // E d(j) d(j)^T for a normal that scatters alike in all directions of its plane: A^T (I - n n^T) A tilt^2.
  const double t = w * pair.tilt_rad * pair.tilt_rad, a2 = squared_norm(arm);
  const double along[6][6] = {
      {a2 - arm.x * arm.x, -arm.x * arm.y, -arm.x * arm.z, 0, -arm.z, arm.y},
      {0, a2 - arm.y * arm.y, -arm.y * arm.z, arm.z, 0, -arm.x},
      {0, 0, a2 - arm.z * arm.z, -arm.y, arm.x, 0},
      {0, 0, 0, 1, 0, 0},
      {0, 0, 0, 0, 1, 0},
      {0, 0, 0, 0, 0, 1}};
  for (size_t r = 0; r < 6; ++r) {
    sums.right[r] -= w * pair.residual_m * j[r];
    for (size_t c = r; c < 6; ++c) {
      const double jj = j[r] * j[c];
      sums.normal[6 * r + c] += w * jj;
      sums.noise[6 * r + c] += t * (along[r][c] - jj);
    }
  }
}

void add_pair(const IcpPair& pair, IcpMetric metric, const RobustKernel& kernel,
              const IcpFrame& frame, IcpSums& sums) {
  const double w = kernel.weight(pair.residual_m);
  if (w == 0) return;
  sums.squares += w * pair.residual_m * pair.residual_m;
  sums.weights += w;
  sums.slopes += kernel.slope(pair.residual_m);
  ++sums.pairs;
  if (metric == IcpMetric::kPointToPlane) return add_plane_pair(pair, w, frame, sums);
  PairTerm terms[3];
  for (size_t k = 0; k < pair_terms(pair, metric, terms); ++k) {
    IcpPair term = pair;
    term.normal = terms[k].normal;
    term.residual_m = terms[k].residual_m;
    add_plane_pair(term, w * terms[k].weight, frame, sums);
  }
}

void mirror_of_normal(Square<6>& m) {
  for (size_t r = 0; r < 6; ++r)
    for (size_t c = 0; c < r; ++c) m[6 * r + c] = m[6 * c + r];
}

double quadratic_form(const Square<6>& m, const Coefficients<6>& v) {
  double sum = 0;
  for (size_t r = 0; r < 6; ++r) {
    double row = 0;
    for (size_t c = 0; c < 6; ++c) row += m[6 * r + c] * v[c];
    sum += v[r] * row;
  }
  return sum;
}

}  // namespace

IcpSums& IcpSums::operator+=(const IcpSums& b) {
  for (size_t i = 0; i < 36; ++i) {
    normal[i] += b.normal[i];
    noise[i] += b.noise[i];
  }
  for (size_t i = 0; i < 6; ++i) right[i] += b.right[i];
  squares += b.squares;
  weights += b.weights;
  slopes += b.slopes;
  pairs += b.pairs;
  of_moving += b.of_moving;
  return *this;
}

IcpSums icp_sums(const IcpPairing& at, const RobustKernel& kernel, const IcpFrame& frame,
                 Task& task) {
  const Buffer<uint32_t>&forth = at.neighbours.of_moving, &back = at.neighbours.of_reference;
  IcpSums sums =
      parallel_reduce(task, forth.size(), kNormalGrain, IcpSums{}, [&](size_t begin, size_t end) {
        IcpSums part;
        IcpPair pair;
        for (size_t i = begin; i < end; ++i) {
          const uint32_t m = at.level.moving.position(i), r = forth[i];
          if (r != kNoPoint && pair_of(at, m, r, PairWay::kForth, pair))
            add_pair(pair, at.rule.metric, kernel, frame, part);
        }
        part.of_moving = part.pairs;
        return part;
      });
  sums +=
      parallel_reduce(task, back.size(), kNormalGrain, IcpSums{}, [&](size_t begin, size_t end) {
        IcpSums part;
        IcpPair pair;
        for (size_t i = begin; i < end; ++i) {
          const uint32_t m = back[i], r = at.level.reference.position(i);
          if (m != kNoPoint && pair_of(at, m, r, PairWay::kBack, pair))
            add_pair(pair, at.rule.metric, kernel, frame, part);
        }
        return part;
      });
  mirror_of_normal(sums.normal);
  mirror_of_normal(sums.noise);
  return sums;
}

std::vector<float> icp_residual_sample(const IcpPairing& at) {
  std::vector<float> out;
  IcpPair pair;
  const Buffer<uint32_t>&forth = at.neighbours.of_moving, &back = at.neighbours.of_reference;
  for (size_t i = 0; i < forth.size(); i += forth.size() / kResidualSample + 1) {
    const uint32_t m = at.level.moving.position(i), r = forth[i];
    if (r != kNoPoint && pair_of(at, m, r, PairWay::kForth, pair))
      out.push_back(static_cast<float>(pair.residual_m));
  }
  for (size_t i = 0; i < back.size(); i += back.size() / kResidualSample + 1) {
    const uint32_t m = back[i], r = at.level.reference.position(i);
    if (m != kNoPoint && pair_of(at, m, r, PairWay::kBack, pair))
      out.push_back(static_cast<float>(pair.residual_m));
  }
  return out;
}

IcpDirections icp_directions(const IcpSums& sums, double over_noise) {
  Square<6> without_noise;
  for (size_t i = 0; i < 36; ++i) without_noise[i] = sums.normal[i] - sums.noise[i];
  const Eigen6 eigen = symmetric_eigen(without_noise, 1);  // turns are lengths already
  IcpDirections out{.unit = eigen.vectors, .information = eigen.values};
  const double strongest = out.information[5];
  for (size_t k = 0; k < 6; ++k) {
    const double of_noise = quadratic_form(sums.noise, out.unit[k]);
    out.observable[k] = out.information[k] > over_noise * of_noise &&
                        out.information[k] > kNormalLeastShare * strongest;
  }
  return out;
}

Coefficients<6> icp_step(const IcpSums& sums, const IcpDirections& directions) {
  Coefficients<6> step{};
  for (size_t k = 0; k < 6; ++k) {
    if (!directions.observable[k]) continue;
    double along = 0;
    for (size_t i = 0; i < 6; ++i) along += directions.unit[k][i] * sums.right[i];
    for (size_t i = 0; i < 6; ++i)
      step[i] += directions.unit[k][i] * along / directions.information[k];
  }
  return step;
}

}  // namespace jalon
