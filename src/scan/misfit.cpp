// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/misfit.h"

#include <cmath>

#include "base/random.h"

namespace jalon {

namespace {

constexpr uint64_t kMisfitKey = 0x6d'69'73'66'69'74;  // "misfit": its streams are none of the rays'

/// Turn about the vector's direction by its length (Rodrigues 1840).
Transform rotation_by(const Vec3& vector_rad) {
  Transform out;
  const double angle = norm(vector_rad);
  if (!(angle > 0)) return out;
  const Vec3 k = vector_rad / angle;
  const double s = std::sin(angle), c = std::cos(angle);
  const double w[3][3] = {{0, -k.z, k.y}, {k.z, 0, -k.x}, {-k.y, k.x, 0}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      out.m[static_cast<size_t>(4 * i + j)] =
          (i == j ? c : 0) + s * w[i][j] + (1 - c) * k[i] * k[j];
  return out;
}

}  // namespace

Misfit::Misfit(const StaticSettings& settings, size_t station)
    : is_none_(!(settings.misfit_shift_m > 0) && !(settings.misfit_rotation_rad > 0)) {
  RandomStream random(settings.seed ^ kMisfitKey, station);
  Vec3 turn;
  for (int a = 0; a < 3; ++a) shift_[a] = settings.misfit_shift_m * random.normal();
  for (int a = 0; a < 3; ++a) turn[a] = settings.misfit_rotation_rad * random.normal();
  rotation_ = rotation_by(turn);
}

Transform Misfit::recorded(const Transform& pose) const {
  if (is_none_) return pose;
  Transform out = rotation_ * pose;
  const Vec3 centre = pose.translation() + shift_;
  for (int a = 0; a < 3; ++a) out.m[static_cast<size_t>(4 * a + 3)] = centre[a];
  return out;
}

}  // namespace jalon
