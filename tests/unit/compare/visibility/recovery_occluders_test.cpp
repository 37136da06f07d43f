// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Hidden zones and the points that hide them, against a loop over those points.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>

#include "base/numbers.h"
#include "compare/visibility/recovery.h"
#include "geometry/rigid_motion.h"
#include "unit/compare/lattice.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const Look kNarrow{-0.2, 0.2, -0.2, 0.2, 0.01, 0.01, 0};

/// A relief 5 m before the scanner.
double relief(const Vec3& d) {
  double range = 5 / d.y;
  for (int k = 0; k < 40; ++k)
    range = (5 + 0.25 * std::sin(6 * d.x * range) * std::cos(5 * d.z * range)) / d.y;
  return range;
}

struct Zone {
  OccluderMatch match;
  std::vector<uint32_t> occluders;  ///< kNoPoint where none
  Cloud cloud;
};

Zone matched(const Cloud& reference, Cloud cloud, double zone_m = 0.5) {
  Task task;
  const VisibilityTest test(reference, {}, task);
  std::vector<uint64_t> all;
  Zone out;
  for (size_t i = 0; i < cloud.size(); ++i) {
    all.push_back(i);
    test.label(cloud.point(i), &out.occluders.emplace_back());
  }
  out.match = match_occluders(reference, cloud, test, all, zone_m, task);
  out.cloud = std::move(cloud);
  return out;
}

}  // namespace

TEST_CASE("match_occluders__gives_each_point_its_distance_from_those_that_hide_its_zone") {
  const Cloud before = lattice(kNarrow, {}, relief);
  const Zone zone = matched(before, lattice(kNarrow, {}, [](const Vec3& d) { return 7 / d.y; }));
  const std::set<uint32_t> hiders(zone.occluders.begin(), zone.occluders.end());
  REQUIRE(hiders.count(kNoPoint) == 0);
  for (size_t i = 0; i < zone.cloud.size(); i += 7) {
    double least = std::numeric_limits<double>::infinity();
    for (const uint32_t h : hiders)
      least = std::min(least, norm(before.point(h) - zone.cloud.point(i)));
    REQUIRE(zone.match.distances[i] == doctest::Approx(least).epsilon(1e-9));
    REQUIRE(zone.match.residuals[i] == zone.match.residuals[0]);  // one zone
  }
}

TEST_CASE("match_occluders__a_moved_copy_fits_and_another_shape_does_not") {
  Task task;
  const Cloud before = lattice(kNarrow, {}, relief);
  const Transform back = motion_about({0, 5, 0}, {0, 0, 0.1}, {0, 0.35, 0});
  const Zone copy = matched(before, transformed(before, back, task));
  const Zone other = matched(before, lattice(kNarrow, {}, [](const Vec3& d) {
                               return (6 + 2 * std::fabs(d.x / d.y) / 0.2) / d.y;
                             }));
  // The copy's points come back onto themselves but for a rim that nothing of it hides.
  CHECK(copy.match.ratios[0] < 1);
  CHECK(other.match.ratios[0] > 2);
  CHECK(copy.match.residuals[0] < other.match.residuals[0]);
}

TEST_CASE("match_occluders__tells_zones_apart_and_says_nothing_where_none_hides") {
  // Two posts 3 m before the scanner, 1.2 m apart; of what lies behind the right one all is as far as the left one's.
  const auto posts = [](double range) {
    return [range](const Vec3& d) {
      return std::fabs(std::fabs(d.x / d.y) - 0.15) < 0.04 ? range / d.y : 0;
    };
  };
  const Cloud before = lattice(kNarrow, {}, posts(3));
  const Zone behind = matched(before, lattice(kNarrow, {}, posts(3.5)));
  for (size_t i = 0; i < behind.cloud.size(); ++i)
    REQUIRE(behind.match.distances[i] == doctest::Approx(0.5).epsilon(0.05).scale(0));
  // Visible points have no occluder.
  const Zone seen = matched(before, lattice(kNarrow, {}, posts(2.5)));
  for (size_t i = 0; i < seen.cloud.size(); ++i) {
    REQUIRE(std::isnan(seen.match.distances[i]));
    REQUIRE(std::isnan(seen.match.residuals[i]));
    REQUIRE(std::isnan(seen.match.ratios[i]));
  }
  // One point that hides another has a place and no shape.
  const Look single{0, 0, 0, 0, 1, 1, 0};
  Task task;
  const Zone one =
      matched(lattice(single, {}, wall_at(3)),
              append(lattice(single, {}, wall_at(5)), lattice(single, {}, wall_at(5.2)), task));
  REQUIRE(one.match.distances.size() == 2);
  CHECK(one.match.distances[0] == doctest::Approx(2));
  CHECK(one.match.residuals[0] == doctest::Approx(0.1).scale(0));  // both about their middle
  CHECK(std::isnan(one.match.ratios[0]));
  const VisibilityTest test(before, {}, task);
  CHECK(match_occluders(before, before, test, {}, 0.5, task).distances.empty());
}
