// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/contaminated_plane.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

#include "base/random.h"
#include "geometry/contamination.h"

using namespace jalon;

namespace {

constexpr double kTolerance_m = 0.025, kSigma_m = 0.006;
constexpr double kChiSquare99 = 11.345;

struct ContaminatedPlaneDraw {
  std::vector<Vec3> points;
  std::vector<uint32_t> zones;
};

// A strip of 0.4 x 2.4 m seen from the front, noise along z; along its right edge a share of points of the surface
// that leads back from there.
ContaminatedPlaneDraw strip(uint64_t seed, size_t own, size_t foreign) {
  RandomStream random(seed, 1);
  ContaminatedPlaneDraw out;
  for (size_t i = 0; i < own; ++i) {
    const double u = 0.4 * random.uniform(), v = 2.4 * random.uniform();
    out.points.push_back({u, v, kSigma_m * random.normal()});
    out.zones.push_back(u > 0.025 && u < 0.375 ? 1 : 0);
  }
  while (out.points.size() < own + foreign) {
    const double depth = 0.1 * random.uniform(), z = kSigma_m * random.normal() - depth;
    if (std::abs(z) > kTolerance_m) continue;
    out.points.push_back({0.4, 2.4 * random.uniform(), z});
    out.zones.push_back(0);
  }
  return out;
}

PlaneFit least_squares(const ContaminatedPlaneDraw& draw) {
  PlaneFit fit;
  REQUIRE(fit_plane(draw.points, fit));
  if (fit.plane.normal.z < 0) turn_over(fit);
  return fit;
}

bool settle(const ContaminatedPlaneDraw& draw, PlaneFit& fit) {
  Task task;
  std::vector<PlaneSample> samples;
  for (size_t i = 0; i < draw.points.size(); ++i) {
    const Vec3 d = draw.points[i] - fit.centroid;
    samples.push_back({static_cast<float>(dot(d, fit.axis_u)),
                       static_cast<float>(dot(d, fit.axis_v)),
                       static_cast<float>(dot(d, fit.plane.normal)), draw.zones[i]});
  }
  return settle_contaminated_plane(samples, kTolerance_m, task, fit);
}

// Squared distance of the plane z = 0 in the covariance of the fit.
double chi_square(const PlaneFit& fit) {
  const Vec3 turn = fit.plane.normal - Vec3{0, 0, 1};
  const Vec3 y{-dot(turn, fit.axis_u), -dot(turn, fit.axis_v), fit.centroid.z};
  const Symmetric3& c = fit.local_covariance;
  const Vec3 rows[3] = {{c[0], c[1], c[2]}, {c[1], c[3], c[4]}, {c[2], c[4], c[5]}};
  const double determinant = dot(rows[0], cross(rows[1], rows[2]));
  const Vec3 x{dot(y, cross(rows[1], rows[2])), dot(y, cross(rows[2], rows[0])),
               dot(y, cross(rows[0], rows[1]))};
  return dot(x, y) / determinant;
}

struct Coverage {
  double least_squares = 0, settled = 0;
};

Coverage coverage(size_t own, size_t foreign, uint64_t draws) {
  Coverage out;
  for (uint64_t seed = 1; seed <= draws; ++seed) {
    const ContaminatedPlaneDraw draw = strip(seed, own, foreign);
    PlaneFit fit = least_squares(draw);
    out.least_squares += chi_square(fit) <= kChiSquare99;
    settle(draw, fit);
    out.settled += chi_square(fit) <= kChiSquare99;
  }
  out.least_squares /= static_cast<double>(draws);
  out.settled /= static_cast<double>(draws);
  return out;
}

uint64_t draw_count() { return std::getenv("JALON_SANITIZED") != nullptr ? 100 : 1000; }

}  // namespace

TEST_CASE("contaminated_plane__covariance_holds_where_a_second_surface_meets_the_first") {
  const Coverage many = coverage(400, 40, draw_count()), few = coverage(90, 12, draw_count());
  MESSAGE("FIGURE contaminated plane, 99 %: 400 + 40 points "
          << many.settled << " (least squares " << many.least_squares << "), 90 + 12 points "
          << few.settled << " (least squares " << few.least_squares << ")");
  CHECK(many.settled >= 0.97);
  CHECK(many.least_squares <= 0.5);  // otherwise there was nothing to settle
  CHECK(few.settled >= 0.95);
}

TEST_CASE("contaminated_plane__is_least_squares_among_points_of_its_own") {
  const Coverage clean = coverage(400, 0, draw_count());
  MESSAGE("FIGURE clean plane, 99 %: " << clean.settled << " (least squares " << clean.least_squares
                                       << ")");
  CHECK(clean.settled >= 0.97);
  double squares = 0, settled_squares = 0;
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    const ContaminatedPlaneDraw draw = strip(seed, 400, 0);
    PlaneFit fit = least_squares(draw);
    squares += fit.centroid.z * fit.centroid.z;
    REQUIRE(settle(draw, fit));
    settled_squares += fit.centroid.z * fit.centroid.z;
  }
  CHECK(settled_squares <= 1.2 * squares);  // efficiency
}

TEST_CASE("contaminated_plane__from_a_start_among_few_of_many_comes_to_the_same_maximum") {
  const ContaminatedPlaneDraw many = strip(7, 78000, 2000);  // as many as have such a start
  ContaminatedPlaneDraw fewer = many;
  fewer.points.pop_back();
  fewer.zones.pop_back();
  PlaneFit a = least_squares(many), b = least_squares(fewer);
  REQUIRE(settle(many, a));
  REQUIRE(settle(fewer, b));
  const double standard_error_m = kSigma_m / std::sqrt(78000.0);
  for (const Vec3& p : {Vec3{0.2, 1.2, 0}, Vec3{0.4, 0, 0}, Vec3{0, 2.4, 0}})
    CHECK(std::fabs(a.plane.distance(p) - b.plane.distance(p)) < 0.05 * standard_error_m);
}

TEST_CASE("contaminated_plane__leaves_what_it_cannot_tell") {
  const ContaminatedPlaneDraw little = strip(1, 12, 0);
  PlaneFit fit = least_squares(little);
  const PlaneFit before = fit;
  CHECK_FALSE(settle(little, fit));
  CHECK(fit.plane.offset == before.plane.offset);
  ContaminatedPlaneDraw exact = strip(1, 100, 0);
  for (Vec3& p : exact.points) p.z = 0;
  PlaneFit flat = least_squares(exact);
  CHECK_FALSE(settle(exact, flat));
  CHECK(flat.plane.normal.z == 1);
}

TEST_CASE("contamination_table__derivatives_are_those_of_its_log_density") {
  const Contamination c{kSigma_m, kTolerance_m, 0.1, 0.05};
  constexpr double kStep = 1e-4;
  const auto density = [&](Contamination other, double r) {
    return ContaminationTable(other, ContaminationTable::With::kLogDensity).log_density(r);
  };
  const ContaminationTable table(c, ContaminationTable::With::kDerivatives);
  const double node_m =
      kTolerance_m / std::ceil(12 * kTolerance_m / kSigma_m);  // at a node nothing is interpolated
  for (const double r : {-30 * node_m, -7 * node_m, 0.0, 12 * node_m, 40 * node_m}) {
    CAPTURE(r);
    const auto d = table.derivatives(r);
    Contamination front = c, behind = c;
    front.front += kStep;
    behind.behind += kStep;
    CHECK((density(front, r) - density(c, r)) / kStep ==
          doctest::Approx(d[ContaminationTable::kF]).epsilon(0.01).scale(0));
    CHECK((density(behind, r) - density(c, r)) / kStep ==
          doctest::Approx(d[ContaminationTable::kB]).epsilon(0.01).scale(0));
    const auto sum = table.weights(r);
    CHECK(sum.core + sum.front + sum.behind == doctest::Approx(1));
  }
}

TEST_CASE("turn_over__keeps_the_covariance_of_normal_and_offset_up_to_its_sign") {
  const ContaminatedPlaneDraw draw = strip(3, 400, 40);
  PlaneFit fit = least_squares(draw);
  REQUIRE(settle(draw, fit));
  shift_origin(fit, {10, -20, 5});
  PlaneFit turned = fit;
  turn_over(turned);
  update_covariance(turned);
  for (size_t k = 0; k < 16; ++k)
    CHECK(turned.covariance[k] == doctest::Approx(fit.covariance[k]).epsilon(1e-9).scale(1e-9));
}
