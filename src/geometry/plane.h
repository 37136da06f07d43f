// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/symmetric_eigen.h"
#include "geometry/vec.h"

namespace jalon {

/// normal . p = offset, |normal| = 1.
struct Plane {
  Vec3 normal{0, 0, 1};
  double offset = 0;
  double distance(const Vec3& p) const { return dot(normal, p) - offset; }
};

/// Running sums about a reference point near the data, so that map coordinates lose nothing. Sums
/// of parts, added in a fixed
/// order, give the same bits for any number of threads.
struct Moments {
  Vec3 reference;
  uint64_t n = 0;
  Vec3 sum;
  Symmetric3 products{};  ///< sums of products of coordinates relative to the reference

  void add(const Vec3& p) {
    const Vec3 d = p - reference;
    ++n;
    sum += d;
    products[0] += d.x * d.x;
    products[1] += d.x * d.y;
    products[2] += d.x * d.z;
    products[3] += d.y * d.y;
    products[4] += d.y * d.z;
    products[5] += d.z * d.z;
  }
  /// As many equal points.
  void add(const Vec3& p, uint64_t count) {
    const Vec3 d = p - reference, sum_of_all = d * static_cast<double>(count);
    n += count;
    sum += sum_of_all;
    products[0] += sum_of_all.x * d.x;
    products[1] += sum_of_all.x * d.y;
    products[2] += sum_of_all.x * d.z;
    products[3] += sum_of_all.y * d.y;
    products[4] += sum_of_all.y * d.z;
    products[5] += sum_of_all.z * d.z;
  }
  /// Both must have the same reference.
  Moments& operator+=(const Moments& b) {
    n += b.n;
    sum += b.sum;
    for (size_t i = 0; i < 6; ++i) products[i] += b.products[i];
    return *this;
  }
  Vec3 centroid() const { return reference + sum / static_cast<double>(n); }
  /// Divided by n.
  Symmetric3 covariance() const;
};

/// Orthogonal least-squares plane (Boulaassal 2010, 3.26-3.28) with the covariance of its parameters.
struct PlaneFit {
  Plane plane;
  Vec3 centroid, axis_u, axis_v;      ///< axis_u: largest extent; axis_u x axis_v = normal
  std::array<double, 3> eigenvalues;  ///< of the covariance (divided by n), ascending
  uint64_t n = 0;
  double sigma = 0;  ///< sqrt(sum of squared distances / (n - 3)); 0 for n = 3
  /// In the plane's own frame, of w = alpha u + beta v + gamma from the centroid: of (alpha, beta, gamma).
  Symmetric3 local_covariance{};
  std::array<double, 16> covariance{};  ///< of (nx, ny, nz, offset), row-major, rank 3
};

/// False when fewer than 3 points, or collinear (second eigenvalue <= 1e-12 of the largest).
bool fit_plane(const Moments& moments, PlaneFit& out);
bool fit_plane(std::span<const Vec3> points, PlaneFit& out);
/// Root of the mean squared distance of the points to any plane; their number must not be 0.
double rms_about(const Moments& moments, const Plane& plane);
/// The same fit in coordinates q = p + shift: moves centroid and offset and propagates the
/// covariance of the offset, which grows with
/// the distance of the origin from the centroid.
void shift_origin(PlaneFit& fit, const Vec3& shift);
/// The same plane seen from its other side; axis_u stays.
void turn_over(PlaneFit& fit);
/// Sets the covariance of (normal, offset) from the local one.
void update_covariance(PlaneFit& fit);
/// Plane through three points; false when they are (nearly) collinear: |cross| <= 1e-3 |a| |b|.
bool plane_through(const Vec3& a, const Vec3& b, const Vec3& c, Plane& out);

}  // namespace jalon
