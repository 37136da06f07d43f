// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/distributions.h"
#include "base/random.h"
#include "geometry/symmetric_eigen.h"
#include "modelling/plane/vertex_covariance.h"

using namespace jalon;

namespace {

constexpr int kDraws = 10000;

// Mean outer product of deviations, and the share of them inside the 95 % ellipsoid of the covariance told.
struct Spread {
  Covariance3 covariance{};
  double coverage = 0;
};

double mahalanobis(const Covariance3& c, const Vec3& d) {
  const Eigen3 eigen = symmetric_eigen({c[0], c[1], c[2], c[4], c[5], c[8]});
  double sum = 0;
  for (size_t i = 0; i < 3; ++i)
    sum += dot(eigen.vectors[i], d) * dot(eigen.vectors[i], d) / eigen.values[i];
  return sum;
}

template <class Draw>
Spread spread_of(const Covariance3& told, Draw&& draw) {
  const double limit = chi_square_quantile(3, 0.95);
  Spread out;
  for (int k = 0; k < kDraws; ++k) {
    RandomStream random(5, static_cast<uint64_t>(k));
    const Vec3 d = draw(random);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        out.covariance[static_cast<size_t>(3 * i + j)] += d[i] * d[j] / kDraws;
    if (mahalanobis(told, d) <= limit) out.coverage += 1.0 / kDraws;
  }
  return out;
}

// Elements within 5 % of the largest variances they belong to.
void check_alike(const Covariance3& told, const Spread& seen) {
  double worst = 0;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) {
      const double scale = std::sqrt(told[4 * i] * told[4 * j]);
      worst = std::max(worst, std::fabs(told[3 * i + j] - seen.covariance[3 * i + j]) / scale);
    }
  MESSAGE("FIGURE largest element off by ", worst, " of its variances; 95 % ellipsoid covers ",
          seen.coverage);
  CHECK(worst < 0.05);
  CHECK(seen.coverage > 0.93);
  CHECK(seen.coverage < 0.97);
}

Vec3 meeting(const Plane& a, const Plane& b, const Plane& c) {
  const double d = dot(a.normal, cross(b.normal, c.normal));
  return (cross(b.normal, c.normal) * a.offset + cross(c.normal, a.normal) * b.offset +
          cross(a.normal, b.normal) * c.offset) /
         d;
}

// Points of a 4 x 3 m patch of a plane with noise, fitted.
PlaneFit noisy_fit(const PlaneFrame& frame, double noise_m, RandomStream& random) {
  std::vector<Vec3> points;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 7; ++j)
      points.push_back(frame.lift({0.5 * i, 0.5 * j}) + frame.normal * (noise_m * random.normal()));
  PlaneFit fit;
  REQUIRE(fit_plane(points, fit));
  if (dot(fit.plane.normal, frame.normal) < 0) turn_over(fit);
  return fit;
}

PlaneFrame frame_of(const Vec3& normal, const Vec3& origin) {
  const Vec3 n = normalized(normal);
  return plane_frame({n, dot(n, origin)}, origin, {1, 0, 0});
}

}  // namespace

TEST_CASE("vertex_covariance__of_three_planes_holds_against_10000_fits") {
  const Vec3 corner{12, -7, 3};
  const PlaneFrame frames[3] = {frame_of({0.1, -1, 0.05}, corner), frame_of({1, 0.3, 0}, corner),
                                frame_of({0.02, 0.1, 1}, corner)};
  const double noise_m = 0.004;
  // Told from the covariance that one fit without luck would have: the noise is known.
  std::array<UncertainSurface, 3> surfaces;
  for (size_t s = 0; s < 3; ++s) {
    RandomStream none(1, 1);
    PlaneFit fit = noisy_fit(frames[s], 0, none);
    const double n = static_cast<double>(fit.n), s2 = noise_m * noise_m;
    fit.local_covariance = {s2 / (n * fit.eigenvalues[2]), 0, 0,
                            s2 / (n * fit.eigenvalues[1]), 0, s2 / n};
    update_covariance(fit);
    surfaces[s] = plane_at(fit.plane, fit.covariance, corner);
  }
  const auto told = vertex_covariance(surfaces);
  REQUIRE(told);
  check_alike(*told, spread_of(*told, [&](RandomStream& random) {
    Plane planes[3];
    for (size_t s = 0; s < 3; ++s) planes[s] = noisy_fit(frames[s], noise_m, random).plane;
    return meeting(planes[0], planes[1], planes[2]) - corner;
  }));
}

TEST_CASE("vertex_covariance__of_a_corner_holds_against_10000_drawn_edges_and_planes") {
  const PlaneFrame frame = frame_of({0.2, -1, 0}, {3, 4, 5});
  // The plane as heights over three uncorrelated parameters about a centroid 5 m away.
  PlaneFit fit;
  fit.plane = {frame.normal, dot(frame.normal, frame.origin)};
  fit.axis_u = frame.axis_u, fit.axis_v = frame.axis_v;
  fit.centroid = frame.lift({-4, 3});
  const double sigma_alpha = 3e-4, sigma_beta = 4e-4, sigma_gamma = 1e-3;
  fit.local_covariance = {sigma_alpha * sigma_alpha, 0, 0,
                          sigma_beta * sigma_beta,   0, sigma_gamma * sigma_gamma};
  update_covariance(fit);
  const Vec2 corner{0.5, 0.25};
  const CornerEdge before{{1, 0.2}, 1.2, 0.003, 0.002}, after{{-0.3, 1}, 2.1, 0.002, 0.001};
  const UncertainSurface plane = plane_at(fit.plane, fit.covariance, frame.lift(corner));
  const auto told = corner_covariance(frame, plane, before, after);
  REQUIRE(told);
  // An edge turns about its middle and moves across itself.
  const auto drawn = [&](const CornerEdge& e, double sign, RandomStream& random, Vec2& through,
                         Vec2& direction) {
    const Vec2 along = e.direction * (1 / norm(e.direction)), across{-along.v, along.u};
    through = corner + along * (sign * e.length_m / 2) + across * (e.sigma_m * random.normal());
    const double turn = e.sigma_direction_rad * random.normal();
    direction = along + across * turn;
  };
  check_alike(*told, spread_of(*told, [&](RandomStream& random) {
    Vec2 a, along_a, b, along_b;
    drawn(before, -1, random, a, along_a);
    drawn(after, 1, random, b, along_b);
    const double t = cross(b - a, along_b) / cross(along_a, along_b);
    const Vec2 met = a + along_a * t;
    const Vec3 flat = frame.lift(met);
    const double alpha = sigma_alpha * random.normal(), beta = sigma_beta * random.normal(),
                 gamma = sigma_gamma * random.normal();
    const double w = alpha * dot(flat - fit.centroid, fit.axis_u) +
                     beta * dot(flat - fit.centroid, fit.axis_v) + gamma;
    return flat + frame.normal * w - frame.lift(corner);
  }));
}

TEST_CASE("vertex_covariance__keeps_its_digits_on_a_national_grid") {
  const Vec3 far{652000, 6861000, 150}, corner{12, -7, 3};
  Covariance3 by_fit[2], by_face[2];
  for (size_t k = 0; k < 2; ++k) {
    const Vec3 shift = k == 0 ? Vec3{} : far;
    std::array<UncertainSurface, 3> fits, faces;
    RandomStream random(9, 9);
    const Vec3 normals[3] = {{0.1, -1, 0.05}, {1, 0.3, 0}, {0.02, 0.1, 1}};
    for (size_t s = 0; s < 3; ++s) {
      PlaneFit fit = noisy_fit(frame_of(normals[s], corner), 0.002, random);
      shift_origin(fit, shift);
      fits[s] = plane_at(fit, corner + shift);
      faces[s] = plane_at(fit.plane, fit.covariance, corner + shift);
    }
    const auto of_fits = vertex_covariance(fits), of_faces = vertex_covariance(faces);
    REQUIRE(of_fits);
    REQUIRE(of_faces);
    by_fit[k] = *of_fits;
    by_face[k] = *of_faces;
  }
  const double scale = by_fit[0][0];
  for (size_t i = 0; i < 9; ++i) {
    CHECK(std::fabs(by_fit[1][i] - by_fit[0][i]) < 1e-8 * scale);
    CHECK(std::fabs(by_face[0][i] - by_fit[0][i]) < 1e-9 * scale);
    CHECK(std::fabs(by_face[1][i] - by_fit[0][i]) <
          2e-9);  // m2: what the rounding of a covariance of 2e6 m2 leaves
  }
}

TEST_CASE("vertex_covariance__refuses_surfaces_without_a_common_point") {
  const UncertainSurface wall{{0, -1, 0}, 0.001}, same{{0, -1, 0}, 0.002}, side{{1, 0, 0}, 0.001},
      unknown{{0, 0, 1}, std::nan("")};
  CHECK_FALSE(vertex_covariance({wall, same, side}));
  CHECK_FALSE(vertex_covariance({wall, side, unknown}));
}
