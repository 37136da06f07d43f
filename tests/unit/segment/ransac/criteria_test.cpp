// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The choices of ransac: tolerance, orientation classes, criterion, draws, strips, curved surfaces.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/error.h"
#include "segment/result/residuals.h"
#include "segment/surface/tolerance.h"
#include "unit/segment/scenes.h"
#include "unit/segment/surrounds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
// The method of the thesis: any three points are a plane, which keeps what it took first.
constexpr const char* kPlain =
    "\"connectivity\": false, \"normals\": \"none\", \"sampling\": \"global\", \"refit\": false, "
    "\"reassign\": false";

std::string plain(const std::string& more) { return "{" + std::string(kPlain) + ", " + more + "}"; }

size_t count_of(const Scene& scene, int face) {
  return static_cast<size_t>(std::count(scene.faces.begin(), scene.faces.end(), face));
}

double share(const Scene& scene, const Segmentation& s, int face, uint32_t label) {
  return static_cast<double>(overlap(scene, s, face, label)) /
         static_cast<double>(count_of(scene, face));
}

Scene strips(uint64_t seed) {
  Scene scene;
  RandomStream random(seed, 7);
  for (int k = 0; k < 6; ++k)
    scene.rectangle(k + 1, {1.5 * k, 0.10 * k, 0}, {1.5, 0, 0}, {0, 0, 8}, 500, 0.005, random);
  return scene;
}

double tilt_deg(const Segment& segment) {
  return std::acos(std::min(1.0, std::fabs(segment.fit.plane.normal.y))) / kDegree;
}

// Two sills 0.3 m deep and 1 m long on a wall of 10 x 6 m, 4 m apart; the gap separates them from the wall.
Scene sills(double gap_m, uint64_t seed) {
  Scene scene;
  RandomStream random(seed, 9);
  scene.rectangle(1, {0, 0, 0}, {10, 0, 0}, {0, 0, 6}, 60000, 0.004, random);
  for (int k = 0; k < 2; ++k)
    scene.rectangle(2 + k, {2.0 + 5 * k, -gap_m - 0.3, 1}, {1, 0, 0}, {0, 0.3, 0}, 600, 0.004,
                    random);
  return scene;
}

Scene column(double radius_m, uint64_t seed) {
  Scene scene;
  RandomStream random(seed, 4);
  for (int i = 0; i < 8000; ++i) {
    const double angle = 2 * std::numbers::pi * random.uniform(),
                 r = radius_m + 0.003 * random.normal();
    scene.points.push_back({r * std::cos(angle), r * std::sin(angle), 4 * random.uniform()});
    scene.faces.push_back(0);
  }
  return scene;
}

}  // namespace

TEST_CASE(
    "S2 surrounds: the five tolerances shatter, split and merge the facade as the thesis shows") {
  struct Row {
    double tolerance_m;
    size_t least, most;            // planes
    double wall_least, wall_most;  // share of the wall in the first plane
  };
  // The recipe's five seeds gave 10-11, 6-8, 3, 3 and 2 planes, 56-59, 88-90, 100, - and 100 % of the wall, and of the
  // surrounds 52-76 % at 0.05 and 90-100 % at 0.15, of the joinery 29-47 %. It does not tell how
  // its 60 000 points are shared
  // among the surfaces: the limits leave a little room for that.
  constexpr Row kRows[] = {{0.005, 10, 13, 0.56, 0.60},
                           {0.010, 6, 8, 0.88, 0.91},
                           {0.025, 3, 3, 0.999, 1},
                           {0.050, 3, 3, 0.99, 1},
                           {0.150, 2, 2, 0.99, 1}};
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const Scene scene = surrounds(seed, 250);  // 5 % of the points
    const CloudPtr cloud = cloud_of(scene.points);
    for (const Row& row : kRows) {
      CAPTURE(seed);
      CAPTURE(row.tolerance_m);
      RansacSettings settings = ransac_params(plain("\"min_points\": 600").c_str(), seed);
      settings.surface.distance_tolerance_m = row.tolerance_m;
      const Segmentation s = run(cloud, settings);
      CHECK(s.segments.size() >= row.least);
      CHECK(s.segments.size() <= row.most);
      REQUIRE(!s.segments.empty());
      const double wall = share(scene, s, 1, 1), surround = share(scene, s, 2, 1),
                   joinery = share(scene, s, 3, 1);
      MESSAGE("FIGURE S2 " << row.tolerance_m << ": " << s.segments.size()
                           << " planes, in the first " << wall << " of the wall, " << surround
                           << " of the surrounds, " << joinery << " of the joinery");
      CHECK(wall >= row.wall_least);
      CHECK(wall <= row.wall_most);
      if (row.tolerance_m == 0.050) CHECK((surround >= 0.50 && surround <= 0.78));
      if (row.tolerance_m == 0.150) CHECK((surround >= 0.80 && joinery >= 0.25 && joinery <= 0.49));
    }
  }
}

TEST_CASE(
    "S7 oblique trap: points alone make slanted planes, one orientation class makes one strip a "
    "plane") {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const Scene scene = strips(seed);
    const CloudPtr cloud = cloud_of(scene.points);
    const Segmentation trapped =
        run(cloud, ransac_params(plain("\"max_planes\": 1").c_str(), seed));
    REQUIRE(trapped.segments.size() == 1);
    const Segmentation s =
        run(cloud, ransac_params(plain("\"orientation_order\": \"parallel\"").c_str(), seed));
    REQUIRE(s.segments.size() == 6);
    double worst = 0;
    for (const Segment& segment : s.segments) {
      worst = std::max(worst, tilt_deg(segment));
      double best = 0;
      for (int face = 1; face <= 6; ++face)
        best = std::max(best, share(scene, s, face, segment.label));
      CHECK(best > 0.97);
      CHECK(static_cast<double>(segment.fit.n) / static_cast<double>(scene.points.size()) < 0.18);
    }
    MESSAGE("FIGURE S7: cardinality alone "
            << 100.0 * static_cast<double>(trapped.segments[0].fit.n) / 3000
            << " % in a plane tilted " << tilt_deg(trapped.segments[0])
            << " deg; with classes tilt " << worst << " deg");
    CHECK(tilt_deg(trapped.segments[0]) > 3);
    CHECK(trapped.segments[0].fit.n > 0.5 * 3000);
    CHECK(worst < 0.5);
  }
}

TEST_CASE("orientation classes come in the order asked for, and no others") {
  const Scene scene = facade_scene(1500, 2);
  const CloudPtr cloud = cloud_of(scene.points);
  const Segmentation all =
      run(cloud, ransac_params("{\"orientation_order\": \"vertical horizontal inclined parallel\", "
                               "\"distance_tolerance_m\": 0.015, \"strip_width_m\": 0.1}"));
  CHECK(all.segments.size() == 18);
  const Segmentation flat =
      run(cloud, ransac_params("{\"orientation_order\": \"horizontal\", \"distance_tolerance_m\": "
                               "0.015, \"strip_width_m\": 0.1}"));
  // Without the walls the points of their strips stay with the sills and turn some of them out of the class.
  CHECK(flat.segments.size() >= 3);
  CHECK(flat.segments.size() <= 7);
  for (const Segment& segment : flat.segments)
    CHECK(segment.orientation == Orientation::kHorizontal);
  for (const char* bad : {"sideways", "parallel parallel", "Parallel"}) {
    RansacSettings settings;
    settings.draw.orientation_order = bad;
    CHECK_THROWS_AS(run(cloud, settings), Error);
  }
}

TEST_CASE("S9 sills: connectivity takes both sills and leaves the strip to the wall") {
  for (const double gap : {0.05, 0.0}) {
    CAPTURE(gap);
    const Scene scene = sills(gap, 1);
    const CloudPtr cloud = cloud_of(scene.points);
    // The plane of the sills first, and no normals to tell the strip of the wall apart: the image alone decides.
    const Segmentation s = run(
        cloud,
        ransac_params(
            "{\"normals\": \"none\", \"orientation_order\": \"horizontal parallel\", \"gap_m\": 0, "
            "\"merge_gap_m\": 0, \"reassign\": false, \"strip_width_m\": 0.1}"));
    REQUIRE(s.segments.size() == 3);
    CHECK(share(scene, s, 1, 1) > 0.995);
    for (uint32_t label = 2; label <= 3; ++label) {
      const Segment& sill = s.segments[label - 1];
      MESSAGE("FIGURE S9, gap " << gap << ": sill of " << sill.fit.n << " points, "
                                << overlap(scene, s, 1, label) << " of them the wall's");
      CHECK(sill.orientation == Orientation::kHorizontal);
      CHECK(std::max(share(scene, s, 2, label), share(scene, s, 3, label)) > 0.9);
      CHECK(sill.length_u_m < 1.1);
    }
    const Segmentation with_normals =
        run(cloud, ransac_params("{\"gap_m\": 0, \"merge_gap_m\": 0}"));
    CHECK(with_normals.segments.size() == 3);
  }
}

TEST_CASE(
    "S9 sills: what the strip of the wall held together falls apart once the strip is the wall's") {
  const Scene scene = sills(0, 1);
  // No cut of narrow strips: both sills and the strip between them are one surface until the points are shared out.
  const std::string order =
      "\"orientation_order\": \"horizontal parallel\", \"normals\": \"none\", \"gap_m\": 0, "
      "\"pixel_m\": 0.15";
  const CloudPtr cloud = cloud_of(scene.points);
  const Segmentation kept =
      run(cloud, ransac_params(("{" + order + ", \"reassign\": false}").c_str()));
  REQUIRE(kept.segments.size() == 2);
  CHECK(overlap(scene, kept, 1, 2) > 300);
  const Segmentation s = run(cloud, ransac_params(("{" + order + ", \"merge_gap_m\": 0}").c_str()));
  REQUIRE(s.segments.size() == 3);
  for (uint32_t label = 2; label <= 3; ++label) {
    CHECK(std::max(share(scene, s, 2, label), share(scene, s, 3, label)) > 0.85);
    CHECK(s.segments[label - 1].length_u_m < 3);  // the sills are 4 m apart
  }
}

TEST_CASE("the tolerance comes from sigma by chi-square, or from the cloud itself") {
  CHECK(tolerance_of_sigma(0.008, 0.99, 2) ==
        doctest::Approx(0.008 * std::sqrt(9.2103)).epsilon(1e-4).scale(0));
  CHECK(tolerance_of_sigma(0.008, 0.99, 1) ==
        doctest::Approx(0.008 * 2.5758).epsilon(1e-4).scale(0));
  const Scene scene = facade_scene(1500, 3);
  const CloudPtr cloud = cloud_of(scene.points);
  const Segmentation given =
      run(cloud, ransac_params("{\"tolerance_from\": \"sigma\", \"sigma_m\": 0.003}"));
  CHECK(given.parameters_json.find("0.00772") != std::string::npos);
  Task task;
  const double sigma = estimate_sigma(*cloud, *cloud->octree(task), task);
  MESSAGE("FIGURE estimated sigma " << 1000 * sigma << " mm, true 3 mm");
  CHECK(std::fabs(sigma - 0.003) < 0.1 * 0.003);
  const Segmentation estimated = run(cloud, ransac_params("{\"tolerance_from\": \"estimate\"}"));
  // At 2.6 sigma one point of a hundred is outside: a corner of a plane may be left to itself.
  CHECK(estimated.segments.size() >= 18);
  CHECK(estimated.segments.size() <= 20);
  for (int face = 1; face <= 18; ++face) {
    double best = 0;
    for (const Segment& segment : estimated.segments)
      best = std::max(best, share(scene, estimated, face, segment.label));
    CAPTURE(face);
    CHECK(best > 0.85);
  }
}

TEST_CASE(
    "a fixed number of draws and the criterion of least spread find the facade's planes as well") {
  const Scene scene = facade_scene(400, 6);
  const CloudPtr cloud = cloud_of(scene.points);
  CHECK(run(cloud, ransac_params("{\"draws\": 3000}")).segments.size() == 18);
  CHECK(run(cloud, ransac_params("{\"criterion\": \"standard_deviation\"}")).segments.size() == 18);
  // With very few draws small planes are missed, never the wall.
  const Segmentation few = run(cloud, ransac_params("{\"draws\": 100}"));
  double wall = 0;
  for (const Segment& segment : few.segments)
    wall = std::max(wall, share(scene, few, 1, segment.label));
  CHECK(wall > 0.95);
}

TEST_CASE("a column is no bundle of planes unless asked for") {
  for (const double radius : {0.15, 0.25, 0.4}) {
    CAPTURE(radius);
    const CloudPtr cloud = cloud_of(column(radius, 1).points);
    CHECK(run(cloud, ransac_params()).segments.empty());
    CHECK(!run(cloud, ransac_params("{\"least_radius_m\": 0}")).segments.empty());
  }
  // Flat surfaces as narrow as a strip of a column are planes: small ones are not thrown away by chance.
  size_t found = 0;
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    Scene scene;
    RandomStream random(seed, 5);
    scene.rectangle(1, {0, 0, 0}, {0.15, 0, 0}, {0, 0, 1.5}, 300, 0.003, random);
    found += run(cloud_of(scene.points), ransac_params("{}", seed)).segments.size();
  }
  CHECK(found == 50);
}

TEST_CASE(
    "the histogram of residuals counts every point and fits the normal distribution it came from") {
  Scene scene;
  RandomStream random(6, 0);
  scene.rectangle(1, {0, 0, 0}, {10, 0, 0}, {0, 0, 8}, 100000, 0.0025, random);
  scene.rectangle(2, {0, -3, 0}, {10, 0, 0}, {0, 2, 0}, 10000, 0.004, random);
  const Segmentation s = run(cloud_of(scene.points), ransac_params());
  REQUIRE(s.segments.size() == 2);
  Task task;
  const Residuals all = bin_residuals(s, 0, 50, task), one = bin_residuals(s, 1, 50, task),
                  two = bin_residuals(s, 2, 50, task);
  CHECK(all.count == one.count + two.count);
  CHECK(one.count == s.segments[0].fit.n);
  CHECK(std::fabs(one.mean_m) < 1e-6);
  CHECK(std::fabs(one.sigma_m - 0.0025) < 0.01 * 0.0025);
  CHECK(std::fabs(one.skewness) < 0.05);
  CHECK(std::fabs(one.excess_kurtosis) < 0.1);
  CHECK(all.excess_kurtosis > 0.3);  // two noises are no normal distribution
  double expected = 0, squares = 0;
  uint64_t counted = one.below + one.above;
  for (size_t i = 0; i < one.bins.size(); ++i) {
    const double e =
        one.expected(-one.half_range_m + (static_cast<double>(i) + 0.5) * one.bin_width_m());
    expected += e;
    counted += one.bins[i];
    if (e > 5) squares += std::pow(static_cast<double>(one.bins[i]) - e, 2) / e;
  }
  CHECK(counted == one.count);
  CHECK(expected == doctest::Approx(static_cast<double>(one.count)).epsilon(0.001));
  CHECK(squares < 90);  // chi-square of some 47 degrees of freedom: 99.99 %
}
