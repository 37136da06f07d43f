// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/cut_envelope.h"

#include <algorithm>
#include <limits>

namespace jalon {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = -1e-13;  ///< of weights that should not be negative

bool opposite(double a, double b) { return (a < 0 && b > 0) || (a > 0 && b < 0); }

// Weights proportional to v, which sum to 1; false unless none is negative.
bool normalise(const Vec3& v, Weights& out) {
  const double sum = v.x + v.y + v.z;
  if (sum == 0) return false;
  out = {v.x / sum, v.y / sum, v.z / sum};
  return std::min({out[0], out[1], out[2]}) >= kRounding;
}

Vec3 vector_of(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

}  // namespace

void CutEnvelope::add(const Cut& cut, const Weights& at) {
  if (count_ == kMost) {
    const auto lowest =
        std::min_element(cuts_.begin(), cuts_.end(),
                         [&](const Cut& a, const Cut& b) { return a.at(at) < b.at(at); });
    *lowest = cuts_[--count_];
  }
  cuts_[count_++] = cut;
}

double CutEnvelope::minimise(Weights& where) const {
  double best = kInfinity;
  const auto consider = [&](const Weights& w) {
    double highest = -kInfinity;
    for (size_t k = 0; k < count_ && highest < best; ++k)
      highest = std::max(highest, cuts_[k].at(w));
    if (highest >= best) return;
    best = highest;
    where = w;
  };
  for (size_t i = 0; i < 3; ++i) {
    Weights corner{};
    corner[i] = 1;
    consider(corner);
  }
  for (size_t k = 0; k < count_; ++k)
    for (size_t l = k + 1; l < count_; ++l) {
      const Vec3 first = vector_of(cuts_[k].corners) - vector_of(cuts_[l].corners);
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (!opposite(first[i], first[j])) continue;
        Weights w{};
        w[static_cast<size_t>(j)] = first[i] / (first[i] - first[j]);
        w[static_cast<size_t>(i)] = 1 - w[static_cast<size_t>(j)];
        consider(w);
      }
      for (size_t m = l + 1; m < count_; ++m) {
        Weights w;
        if (normalise(cross(first, vector_of(cuts_[k].corners) - vector_of(cuts_[m].corners)), w))
          consider(w);
      }
    }
  return best;
}

double CutEnvelope::best_mixture(const Vec3& point, double& height, Vec3& slope) const {
  double best = -kInfinity;
  const auto consider = [&](const Cut& a, const Cut& b, const Cut& c, const Weights& share) {
    double lowest = kInfinity;
    for (size_t i = 0; i < 3; ++i)
      lowest = std::min(
          lowest, a.corners[i] * share[0] + b.corners[i] * share[1] + c.corners[i] * share[2]);
    if (lowest <= best) return;
    best = lowest;
    height = a.at(point) * share[0] + b.at(point) * share[1] + c.at(point) * share[2];
    slope = a.gradient * share[0] + b.gradient * share[1] + c.gradient * share[2];
  };
  for (size_t k = 0; k < count_; ++k) {
    const Cut& a = cuts_[k];
    consider(a, a, a, {1, 0, 0});
    for (size_t l = k + 1; l < count_; ++l) {
      const Cut& b = cuts_[l];
      // Two corners at one height.
      for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3;
        const double da = a.corners[i] - a.corners[j], db = b.corners[i] - b.corners[j];
        if (opposite(da, db)) consider(a, b, b, {db / (db - da), -da / (db - da), 0});
      }
      for (size_t m = l + 1; m < count_; ++m) {
        // All three corners at one height.
        const Cut& c = cuts_[m];
        const auto rise = [&](size_t i) {
          return Vec3{a.corners[i] - a.corners[0], b.corners[i] - b.corners[0],
                      c.corners[i] - c.corners[0]};
        };
        Weights share;
        if (normalise(cross(rise(1), rise(2)), share)) consider(a, b, c, share);
      }
    }
  }
  return best;
}

}  // namespace jalon
