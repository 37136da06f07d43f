// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/similarity.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/symmetric_eigen.h"

namespace jalon {

namespace {

constexpr double kCollinear =
    1e-12;  // second eigenvalue against the largest: a line to rounding (fit_plane's)

struct Centroids {
  Vec3 reference, moving;
};

Centroids centroids_of(std::span<const PointPair> pairs) {
  Vec3 reference, moving;
  for (const PointPair& pair : pairs) {
    reference += pair.reference - pairs[0].reference;
    moving += pair.moving - pairs[0].moving;
  }
  const double n = static_cast<double>(pairs.size());
  return {pairs[0].reference + reference / n, pairs[0].moving + moving / n};
}

void add_products(const Vec3& d, Symmetric3& sums) {
  sums[0] += d.x * d.x;
  sums[1] += d.x * d.y;
  sums[2] += d.x * d.z;
  sums[3] += d.y * d.y;
  sums[4] += d.y * d.z;
  sums[5] += d.z * d.z;
}

Transform assembled(const Eigen::Matrix3d& rotation, double scale, const Centroids& centroids) {
  Transform T_reference_moving;
  auto& m = T_reference_moving.m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m[static_cast<size_t>(4 * i + j)] = scale * rotation(i, j);
  const Vec3 t = centroids.reference - T_reference_moving.direction(centroids.moving);
  m[3] = t.x;
  m[7] = t.y;
  m[11] = t.z;
  return T_reference_moving;
}

// What a scale (or 1) and a trace of singular values leave of the squares: |r|^2 - 2 s tr + s^2 |m|^2.
double squares_left(double reference, double moving, double trace, double scale) {
  return std::max(0.0, reference - 2 * scale * trace + scale * scale * moving);
}

}  // namespace

std::optional<SimilarityFit> fit_similarity(std::span<const PointPair> pairs, bool with_scale) {
  if (pairs.size() < 3) return std::nullopt;
  // 1. Both sides about their centroids: spreads and cross-covariance (Umeyama 1991, eq. 34-38, times n).
  const Centroids centroids = centroids_of(pairs);
  Symmetric3 reference{}, moving{};
  Eigen::Matrix3d crossed = Eigen::Matrix3d::Zero();
  for (const PointPair& pair : pairs) {
    const Vec3 r = pair.reference - centroids.reference, m = pair.moving - centroids.moving;
    add_products(r, reference);
    add_products(m, moving);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) crossed(i, j) += r[i] * m[j];
  }
  const Eigen3 of_reference = symmetric_eigen(reference), of_moving = symmetric_eigen(moving);
  for (const Eigen3& eigen : {of_reference, of_moving})
    if (!(eigen.values[1] > kCollinear * eigen.values[2])) return std::nullopt;
  // 2. The rotation; the last singular vector changes sign where it would be a reflection.
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(crossed, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1 : 1;
  const Eigen::Vector3d signs(1, 1, sign), values = svd.singularValues();
  const Eigen::Matrix3d rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  // 3. Scale and shift.
  const double r2 = reference[0] + reference[3] + reference[5],
               m2 = moving[0] + moving[3] + moving[5];
  const double trace = values.dot(signs);
  if (with_scale && !(trace > 0)) return std::nullopt;
  SimilarityFit out;
  out.scale = with_scale ? trace / m2 : 1;
  out.T_reference_moving = assembled(rotation, out.scale, centroids);
  out.squares_m2 = squares_left(r2, m2, trace, out.scale);
  out.mirrored_squares_m2 = squares_left(r2, m2, values.sum(), with_scale ? values.sum() / m2 : 1);
  const double n = static_cast<double>(pairs.size());
  for (size_t i = 0; i < 3; ++i)
    out.spread_m[i] = std::sqrt(std::max(0.0, of_moving.values[2 - i]) / n);
  return out;
}

}  // namespace jalon
