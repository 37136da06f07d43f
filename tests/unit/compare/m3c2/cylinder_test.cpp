// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What one cylinder tells, against loops over all points and the level of detection worked out by hand.
#include "compare/m3c2/cylinder.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

CylinderResult result_in(const M3c2Settings& settings, const Cloud& reference,
                         const Cloud& compared, const Vec3& centre, const Vec3& normal) {
  Task task;
  const CylinderComparer cylinders(settings, std::make_shared<const Cloud>(reference),
                                   std::make_shared<const Cloud>(compared), task);
  CylinderComparer::Work work = cylinders.work();
  return cylinders.at(centre, normal, work);
}

M3c2Settings means_of_all() {
  M3c2Settings settings;
  settings.position = M3c2Settings::Position::kMean;
  settings.surfaces = M3c2Settings::Surfaces::kAll;
  return settings;
}

/// So many points of a level circle of 0.1 m about the z axis, moved aside by y.
std::vector<Vec3> ring_at(double z, size_t n, double y = 0) {
  std::vector<Vec3> points;
  for (size_t i = 0; i < n; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    points.push_back({0.1 * std::cos(turn), y + 0.1 * std::sin(turn), z});
  }
  return points;
}

Cloud with_upright_variance(const std::vector<Vec3>& points, double variance_m2) {
  std::vector<double> values;
  for (size_t i = 0; i < points.size(); ++i)
    for (const double c : {1.0, 0.5, 0.0, 1.0, 0.0, variance_m2}) values.push_back(c);
  Cloud cloud = cloud_of(points);
  cloud.fields.set(make_column<double>({"covariance", ElementType::kFloat64, 6, "m2", ""},
                                       std::span<const double>(values)));
  return cloud;
}

}  // namespace

TEST_CASE("m3c2_cylinder__takes_the_points_in_it_and_no_others") {
  M3c2Settings settings = means_of_all();
  settings.cylinder_radius_m = 0.3;
  settings.max_depth_m = 0.6;
  const auto reference = random_points(3000, 2, 1), compared = random_points(4000, 2, 2);
  const Vec3 centre{0.9, 1.1, 1}, normal = normalized({0.5, -0.3, 0.8});
  const auto mean_along = [&](const std::vector<Vec3>& points, uint32_t& count) {
    double sum = 0;
    for (const Vec3& p : points) {
      const double along = dot(p - centre, normal);
      const bool inside = std::fabs(along) <= 0.6 && norm(p - centre - normal * along) <= 0.3;
      count += inside;
      if (inside) sum += along;
    }
    return sum / count;
  };
  uint32_t in_reference = 0, in_compared = 0;
  const double a = mean_along(reference, in_reference), b = mean_along(compared, in_compared);
  const CylinderResult r =
      result_in(settings, cloud_of(reference), cloud_of(compared), centre, normal);
  CHECK(in_reference > 50);
  CHECK(r.status == CompareStatus::kCompared);
  CHECK(r.reference.count == in_reference);
  CHECK(r.compared.count == in_compared);
  CHECK(std::fabs(r.distance_m - (b - a)) < 1e-13);  // sums of some hundred numbers below 1
}

TEST_CASE("m3c2_cylinder__compares_the_surfaces_nearest_to_the_core_point") {
  auto before = ring_at(0, 20), after = ring_at(0.01, 21);
  for (const Vec3& p : ring_at(0.3, 22)) before.push_back(p);
  for (const Vec3& p : ring_at(0.325, 23)) after.push_back(p);
  const auto at = [&](double z) {
    return result_in({}, cloud_of(before), cloud_of(after), {0, 0, z}, {0, 0, 1});
  };
  CHECK(at(0).distance_m == doctest::Approx(0.01).epsilon(1e-12).scale(0));
  CHECK(at(0).reference.count == 20);
  CHECK(at(0).compared.count == 21);
  CHECK(at(0.3).distance_m == doctest::Approx(0.025).epsilon(1e-12).scale(0));
  CHECK(at(0.3).reference.count == 22);
  CHECK(at(0.3).compared.count == 23);
}

TEST_CASE("m3c2_cylinder__says_whether_nothing_or_too_little_lies_in_it") {
  const Cloud enough = cloud_of(ring_at(0, 5)), few = cloud_of(ring_at(0.01, 4));
  const Cloud aside = cloud_of(ring_at(0, 50, 1));
  const CylinderResult nothing = result_in(means_of_all(), enough, aside, {}, {0, 0, 1});
  CHECK(nothing.status == CompareStatus::kNothingNear);
  CHECK(nothing.compared.count == 0);
  const CylinderResult little = result_in(means_of_all(), enough, few, {}, {0, 0, 1});
  CHECK(little.status == CompareStatus::kTooFewPoints);
  CHECK(little.reference.count == 5);
  CHECK(little.compared.count == 4);
  CHECK(std::isnan(little.distance_m));
  CHECK(std::isnan(little.lod_m));
}

TEST_CASE("m3c2_cylinder__level_joins_point_covariances_and_the_registration") {
  // Variances of the two means, of a shift along z of 2 mm and of a turn of 0.5 mrad about an axis 2 m away add; the
  // registration error joins linearly.
  constexpr double kNormal95 = 1.959963984540054;
  M3c2Settings settings = means_of_all();
  settings.precision_from = M3c2Settings::PrecisionFrom::kCovariances;
  settings.registration_covariance.assign(36, 0.0);
  settings.registration_covariance[0] = 0.0005 * 0.0005;
  settings.registration_covariance[35] = 0.002 * 0.002;
  settings.registration_error_m = 0.003;
  const Cloud reference = with_upright_variance(ring_at(0, 8, 2), 4e-6),
              compared = with_upright_variance(ring_at(0.02, 12, 2), 9e-6);
  const CylinderResult r = result_in(settings, reference, compared, {0, 2, 0}, {0, 0, 1});
  const double variance = 4e-6 / 8 + 9e-6 / 12 + 0.002 * 0.002 + 0.001 * 0.001;
  CHECK(r.distance_m == doctest::Approx(0.02).epsilon(1e-12).scale(0));
  // 1e-9: what the table of quantiles promises.
  CHECK(r.lod_m ==
        doctest::Approx(kNormal95 * (std::sqrt(variance) + 0.003)).epsilon(1e-9).scale(0));
}
