// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "base/random.h"
#include "geometry/rigid_motion.h"
#include "registration/targets/targets.h"

namespace jalon::test {

inline Vec3 within(double reach, RandomStream& random) {
  const double x = reach * (2 * random.uniform() - 1), y = reach * (2 * random.uniform() - 1);
  return {x, y, reach * (2 * random.uniform() - 1)};
}

inline Transform any_motion(RandomStream& random, double scale = 1) {
  const Vec3 centre = within(1, random), turn = within(1.7, random), shift = within(50, random);
  Transform out = motion_about(centre, turn, shift);
  for (size_t i = 0; i < 12; ++i)
    if (i % 4 != 3) out.m[i] *= scale;
  return out;
}

inline Square<3> isotropic(double sigma_m) {
  const double v = sigma_m * sigma_m;
  return {v, 0, 0, 0, v, 0, 0, 0, v};
}

/// Of a laser scanner at the origin: along the ray one sigma, across it another.
inline Square<3> along_ray(const Vec3& place, double along_m, double across_m) {
  const Vec3 u = normalized(place);
  Square<3> out{};
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j)
      out[3 * i + j] = (along_m * along_m - across_m * across_m) * u[static_cast<int>(i)] *
                           u[static_cast<int>(j)] +
                       (i == j ? across_m * across_m : 0);
  return out;
}

/// A normal vector of this covariance, by its Cholesky factor.
inline Vec3 noise_of(const Square<3>& c, RandomStream& random) {
  const double l00 = std::sqrt(c[0]), l10 = c[3] / l00, l20 = c[6] / l00;
  const double l11 = std::sqrt(c[4] - l10 * l10), l21 = (c[7] - l20 * l10) / l11;
  const double l22 = std::sqrt(c[8] - l20 * l20 - l21 * l21);
  const double a = random.normal(), b = random.normal(), d = random.normal();
  return {l00 * a, l10 * a + l11 * b, l20 * a + l21 * b + l22 * d};
}

/// True places of targets in the moving frame, with the covariances that both sides are measured with.
struct Layout {
  std::string name;
  std::vector<Vec3> places;
  std::vector<Square<3>> reference, moving;
  double scale = 1;
  const char* params = "{}";
};

struct TargetSides {
  std::vector<Target> reference, moving;
};

/// Both sides without noise; named by letters.
inline TargetSides exact_sides(std::span<const Vec3> places, const Transform& truth,
                               bool named = true) {
  TargetSides out;
  for (size_t i = 0; i < places.size(); ++i) {
    const std::string name = named ? "T" + std::to_string(i) : "";
    out.moving.push_back({name, places[i], {}});
    out.reference.push_back({name, truth.point(places[i]), {}});
  }
  return out;
}

/// Both sides as measured; the covariances are told along with them.
inline TargetSides measured_sides(const Layout& layout, const Transform& truth,
                                  RandomStream& random) {
  TargetSides out = exact_sides(layout.places, truth);
  for (size_t i = 0; i < layout.places.size(); ++i) {
    out.moving[i].xyz += noise_of(layout.moving[i], random);
    out.reference[i].xyz += noise_of(layout.reference[i], random);
    out.moving[i].covariance = layout.moving[i];
    out.reference[i].covariance = layout.reference[i];
  }
  return out;
}

inline TargetSettings target_params(const char* json = "{}") {
  ParamSet params("registrar targets", targets_rows());
  params.from_json(json);
  return settings_from<TargetSettings>(params);
}

inline Registration registered(const TargetSides& sides, const char* json = "{}") {
  Task task;
  return register_targets(sides.reference, sides.moving, target_params(json), task);
}

/// Rotation about the registration's centre and shift of it that lead from the true pose to the one found.
inline Coefficients<6> pose_error(const Registration& r, const Transform& truth) {
  Transform turn = r.pose * inverse(truth);
  const double scale = std::cbrt(turn.determinant());
  for (size_t i = 0; i < 12; ++i)
    if (i % 4 != 3) turn.m[i] /= scale;
  const Vec3 rotation = rotation_vector(turn);
  // Where the true pose puts the point of the moving side that the one found puts at the centre.
  const Vec3 shift = r.centre - truth.point(inverse(r.pose).point(r.centre));
  return {rotation.x, rotation.y, rotation.z, shift.x, shift.y, shift.z};
}

/// e^T C^-1 e.
template <size_t K>
double squared_length(const Square<K>& covariance, const Coefficients<K>& e) {
  Cholesky<K> factor;
  if (!factor.factor(covariance)) return INFINITY;
  const Coefficients<K> x = factor.solve(e);
  double sum = 0;
  for (size_t i = 0; i < K; ++i) sum += e[i] * x[i];
  return sum;
}

}  // namespace jalon::test
