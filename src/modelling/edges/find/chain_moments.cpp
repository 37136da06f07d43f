// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/chain_moments.h"

#include <algorithm>

namespace jalon {

std::vector<double> weights_by_steps(std::span<const Vec2> chain, double spacing_m) {
  constexpr double kStep = 2;  // spacings
  const size_t n = chain.size();
  std::vector<double> out(n);
  for (size_t i = 0; i < n; ++i) {
    const double step =
        (norm(chain[(i + 1) % n] - chain[i]) + norm(chain[i] - chain[(i + n - 1) % n])) / 2;
    const double share = kStep * spacing_m / std::max(step, kStep * spacing_m);
    out[i] = share * share;
  }
  return out;
}

ChainMoments::ChainMoments(std::span<const Vec2> chain, std::span<const double> weights)
    : count_(chain.size()), running_(2 * chain.size() + 1) {
  Vec2 sum;
  for (const Vec2& p : chain) sum = sum + (p - chain[0]);
  if (!chain.empty()) reference_ = chain[0] + sum * (1 / static_cast<double>(chain.size()));
  for (size_t i = 0; i < 2 * count_; ++i) {
    const Vec2 p = chain[i % count_] - reference_;
    const double z = dot(p, p);
    const Sums add{p.u, p.v, p.u * p.u, p.u * p.v, p.v * p.v, p.u * z, p.v * z, z * z, 1};
    for (size_t k = 0; k < kSums; ++k)
      running_[i + 1][k] = running_[i][k] + weights[i % count_] * add[k];
  }
}

ChainMoments::Stretch ChainMoments::stretch(size_t first, size_t last) const {
  const double n = running_[last + 1][8] - running_[first][8];
  Sums m;
  for (size_t k = 0; k < kSums; ++k) m[k] = (running_[last + 1][k] - running_[first][k]) / n;
  const double z = m[2] + m[4];
  Stretch out;
  out.reference_ = reference_;
  out.central_ = {m[0],
                  m[1],
                  m[2] - m[0] * m[0],
                  m[3] - m[0] * m[1],
                  m[4] - m[1] * m[1],
                  m[5] - m[0] * z,
                  m[6] - m[1] * z,
                  m[7] - z * z};
  out.weight_ = n;
  return out;
}

double ChainMoments::Stretch::squares() const {
  const auto& c = central_;
  const double spread = std::hypot(c[2] - c[4], 2 * c[3]);
  return std::max(0.0, (c[2] + c[4] - spread) / 2) * weight_;
}

ChainMoments::LineFit ChainMoments::Stretch::line() const {
  const auto& c = central_;
  const double angle = 0.5 * std::atan2(2 * c[3], c[2] - c[4]);
  return {{mean(), {std::cos(angle), std::sin(angle)}}, squares()};
}

Vec2 ChainMoments::Stretch::mean() const { return reference_ + Vec2{central_[0], central_[1]}; }

double ChainMoments::Stretch::squares_about(const EdgeLine& line) const {
  const auto& c = central_;
  const Vec2 left{-line.direction.v, line.direction.u};
  const double off = line.distance(mean());
  const double spread =
      c[2] * left.u * left.u + 2 * c[3] * left.u * left.v + c[4] * left.v * left.v;
  return (std::max(0.0, spread) + off * off) * weight_;
}

ChainMoments::ArcFit ChainMoments::Stretch::arc() const {
  constexpr double kFlat = 1e-12;  // smaller over larger variance of points on a line
  const auto& c = central_;
  const double determinant = c[2] * c[4] - c[3] * c[3], trace = c[2] + c[4];
  if (!(determinant > kFlat * trace * trace)) return {};
  // z = 2 a u + 2 b v + const.
  const double a2 = (c[5] * c[4] - c[6] * c[3]) / determinant,
               b2 = (c[6] * c[2] - c[5] * c[3]) / determinant;
  const Vec2 centre{a2 / 2, b2 / 2}, mean{c[0], c[1]}, off = mean - centre;
  const double squared = trace + dot(off, off);
  // z - (fit) = d^2 - r^2 = 2 r (d - r), to first order.
  const double algebraic = std::max(0.0, c[7] - a2 * c[5] - b2 * c[6]);
  return {{reference_ + centre, std::sqrt(squared)}, algebraic / (4 * squared) * weight_};
}

}  // namespace jalon
