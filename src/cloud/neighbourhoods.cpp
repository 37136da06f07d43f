// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/neighbourhoods.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

// As in fit_plane: below this share of the largest eigenvalue the second one is rounding noise.
constexpr double kCollinear = 1e-12;

// A homogeneous polynomial of x, y and z: coefficients in the places of a PowerSums<4>.
using Form = std::array<double, PowerSums<4>::kTerms>;

Form times(const Form& form, int degree, const Vec3& linear) {
  using Sums = PowerSums<4>;
  Form out{};
  for (int c = 0; c <= degree; ++c)
    for (int b = 0; b <= degree - c; ++b) {
      const int a = degree - c - b;
      const double k = form[Sums::index(a, b, c)];
      out[Sums::index(a + 1, b, c)] += k * linear.x;
      out[Sums::index(a, b + 1, c)] += k * linear.y;
      out[Sums::index(a, b, c + 1)] += k * linear.z;
    }
  return out;
}

double sum_of(const Form& form, int degree, const PowerSums<4>& sums) {
  double out = 0;
  for (int c = 0; c <= degree; ++c)
    for (int b = 0; b <= degree - c; ++b) {
      const int a = degree - c - b;
      out += form[PowerSums<4>::index(a, b, c)] * sums.of(a, b, c);
    }
  return out;
}

// The sums along the axes of the frame.
QuadricSums turned(const PowerSums<4>& sums, const PrincipalFrame& frame) {
  constexpr int kMost = 4, kMostWithHeight = 2;
  QuadricSums out{};
  Form of_u{1};
  for (int i = 0; i <= kMost; ++i) {
    Form of_uv = of_u;
    for (int j = 0; i + j <= kMost; ++j) {
      out.powers[i][j] = sum_of(of_uv, i + j, sums);
      if (i + j <= kMostWithHeight)
        out.heights[i][j] = sum_of(times(of_uv, i + j, frame.n), i + j + 1, sums);
      if (i + j < kMost) of_uv = times(of_uv, i + j, frame.v);
    }
    if (i < kMost) of_u = times(of_u, i, frame.u);
  }
  return out;
}

}  // namespace

bool principal_frame(const Moments& moments, PrincipalFrame& out) {
  if (moments.n < 3) return false;
  const Eigen3 eigen = symmetric_eigen(moments.covariance());
  if (!(eigen.values[1] > kCollinear * eigen.values[2])) return false;
  out.centre = moments.centroid();
  out.n = eigen.vectors[0];
  out.u = eigen.vectors[2];
  out.v = cross(out.n, out.u);
  for (size_t i = 0; i < 3; ++i) out.eigenvalues[i] = std::max(0.0, eigen.values[i]);
  return true;
}

bool local_quadric(const PrincipalFrame& frame, std::span<const Vec3> points, const Vec3& at,
                   std::vector<Vec3>& work, LocalQuadric& out) {
  const auto to_frame = [&](const Vec3& p) {
    const Vec3 d = p - frame.centre;
    return Vec3{dot(d, frame.u), dot(d, frame.v), dot(d, frame.n)};
  };
  work.clear();
  double scale = 0;
  for (const Vec3& p : points) {
    work.push_back(to_frame(p));
    scale = std::max({scale, std::fabs(work.back().x), std::fabs(work.back().y)});
  }
  if (!fit_quadric(work, scale, out.quadric)) return false;
  const Vec3 own = to_frame(at);
  out.x = own.x;
  out.y = own.y;
  return true;
}

Moments SummedBalls::moments(const Octree::RangedBall& ball) const {
  const double step = tree_.grid_step(), square = step * step;
  const PowerSums<2> sums = planes_.over(ball.ranges, grid_place(tree_, ball.point));
  Moments out;
  out.reference = tree_.local(ball.point);
  out.n = ball.count;
  out.sum = step * Vec3{sums.of(1, 0, 0), sums.of(0, 1, 0), sums.of(0, 0, 1)};
  out.products = {square * sums.of(2, 0, 0), square * sums.of(1, 1, 0), square * sums.of(1, 0, 1),
                  square * sums.of(0, 2, 0), square * sums.of(0, 1, 1), square * sums.of(0, 0, 2)};
  return out;
}

bool SummedBalls::quadric(const PrincipalFrame& frame, const Octree::RangedBall& ball,
                          LocalQuadric& out) const {
  // Seen from the centroid, lengths in radii: the equations are balanced.
  const PowerSums<4> sums = quadrics_->over(ball.ranges, frame.centre / tree_.grid_step())
                                .in_units_of(radius_m_ / tree_.grid_step());
  Quadric q;
  if (!fit_quadric(turned(sums, frame), q)) return false;
  out.quadric = {q.a / radius_m_, q.b, q.c / radius_m_, q.d, q.e / radius_m_, q.f * radius_m_};
  const Vec3 own = tree_.local(ball.point) - frame.centre;
  out.x = dot(own, frame.u);
  out.y = dot(own, frame.v);
  return true;
}

}  // namespace jalon
