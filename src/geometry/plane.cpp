// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/plane.h"

#include <cmath>

namespace jalon {

Symmetric3 Moments::covariance() const {
  const double w = 1 / static_cast<double>(n);
  const Vec3 m = sum * w;
  return {products[0] * w - m.x * m.x, products[1] * w - m.x * m.y, products[2] * w - m.x * m.z,
          products[3] * w - m.y * m.y, products[4] * w - m.y * m.z, products[5] * w - m.z * m.z};
}

namespace {

constexpr double kCollinear = 1e-12;  // second eigenvalue against the largest: a line to rounding

// In the plane's own frame a fit w = alpha u + beta v + gamma has independent parameters.
Symmetric3 least_squares_covariance(const PlaneFit& fit) {
  const double n = static_cast<double>(fit.n), s2 = fit.sigma * fit.sigma;
  return {s2 / (n * fit.eigenvalues[2]), 0, 0, s2 / (n * fit.eigenvalues[1]), 0, s2 / n};
}

}  // namespace

bool fit_plane(const Moments& moments, PlaneFit& out) {
  if (moments.n < 3) return false;
  const Eigen3 eigen = symmetric_eigen(moments.covariance());
  if (!(eigen.values[1] > kCollinear * eigen.values[2])) return false;
  PlaneFit fit;
  fit.n = moments.n;
  fit.centroid = moments.centroid();
  fit.plane.normal = eigen.vectors[0];
  fit.axis_u = eigen.vectors[2];
  fit.axis_v = cross(fit.plane.normal, fit.axis_u);
  fit.plane.offset = dot(fit.plane.normal, fit.centroid);
  fit.eigenvalues = {std::max(eigen.values[0], 0.0), eigen.values[1], eigen.values[2]};
  const double n = static_cast<double>(moments.n);
  fit.sigma = moments.n > 3 ? std::sqrt(fit.eigenvalues[0] * n / (n - 3)) : 0;
  fit.local_covariance = least_squares_covariance(fit);
  update_covariance(fit);
  out = fit;
  return true;
}

bool fit_plane(std::span<const Vec3> points, PlaneFit& out) {
  if (points.empty()) return false;
  Moments moments;
  moments.reference = points.front();
  for (const Vec3& p : points) moments.add(p);
  return fit_plane(moments, out);
}

void shift_origin(PlaneFit& fit, const Vec3& shift) {
  fit.centroid += shift;
  fit.plane.offset += dot(fit.plane.normal, shift);
  update_covariance(fit);
}

void turn_over(PlaneFit& fit) {
  fit.plane = {-fit.plane.normal, -fit.plane.offset};
  fit.axis_v =
      -fit.axis_v;  // keeps axis_u x axis_v = normal: alpha and gamma change sign, beta does not
  fit.local_covariance[1] = -fit.local_covariance[1];
  fit.local_covariance[4] = -fit.local_covariance[4];
}

// The normal moves by -alpha axis_u - beta axis_v, the offset by gamma + centroid . d normal.
void update_covariance(PlaneFit& fit) {
  double jacobian[4][3];
  const Vec3 columns[2] = {-fit.axis_u, -fit.axis_v};
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < 3; ++i) jacobian[i][k] = columns[k][i];
    jacobian[3][k] = dot(columns[k], fit.centroid);
  }
  for (int i = 0; i < 3; ++i) jacobian[i][2] = 0;
  jacobian[3][2] = 1;
  const Symmetric3& c = fit.local_covariance;
  const double local[3][3] = {{c[0], c[1], c[2]}, {c[1], c[3], c[4]}, {c[2], c[4], c[5]}};
  fit.covariance = {};
  for (size_t i = 0; i < 4; ++i)
    for (size_t j = 0; j < 4; ++j)
      for (size_t k = 0; k < 3; ++k)
        for (size_t l = 0; l < 3; ++l)
          fit.covariance[4 * i + j] += jacobian[i][k] * local[k][l] * jacobian[j][l];
}

double rms_about(const Moments& moments, const Plane& plane) {
  const Symmetric3 c = moments.covariance();
  const Vec3& n = plane.normal;
  const double spread = c[0] * n.x * n.x + c[3] * n.y * n.y + c[5] * n.z * n.z +
                        2 * (c[1] * n.x * n.y + c[2] * n.x * n.z + c[4] * n.y * n.z);
  const double shift = plane.distance(moments.centroid());
  return std::sqrt(std::max(0.0, spread) + shift * shift);
}

bool plane_through(const Vec3& a, const Vec3& b, const Vec3& c, Plane& out) {
  constexpr double kMinSine = 1e-3;
  const Vec3 u = b - a, v = c - a, n = cross(u, v);
  const double length = norm(n);
  if (!(length > kMinSine * norm(u) * norm(v))) return false;
  out.normal = n / length;
  out.offset = dot(out.normal, a);
  return true;
}

}  // namespace jalon
