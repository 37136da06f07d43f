// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("automatic_stations__stand_in_front_of_a_facade") {
  const auto stations = automatic_stations(scene("facade"));
  REQUIRE(stations.size() == 2);
  for (const ScanStation& station : stations) {
    const Vec3 p = station.pose.translation();
    CHECK(p.y == doctest::Approx(-0.35 - 0.6 * 22));  // in front of the cornice
    CHECK(p.z == doctest::Approx(1.7));
  }
  CHECK(stations[0].pose.translation().x + stations[1].pose.translation().x == doctest::Approx(22));
  CHECK(std::abs(stations[0].pose.translation().x - 11) == doctest::Approx(5.5));
}

TEST_CASE("automatic_stations__stand_where_the_measured_street_was_scanned_from") {
  const auto stations =
      automatic_stations(scene("street", {{"rotation_rad", -17 * 3.14159265358979323846 / 180}}));
  REQUIRE(stations.size() == 2);
  std::vector<double> x;
  for (const ScanStation& station : stations) {
    const Vec3 p = station.pose.translation();
    x.push_back(p.x);
    CHECK(std::abs(p.y) < 1);
    CHECK(p.z == doctest::Approx(1.7));
  }
  std::sort(x.begin(), x.end());
  CHECK(x[0] == doctest::Approx(15).epsilon(0.05));
  CHECK(x[1] == doctest::Approx(45).epsilon(0.05));
}

TEST_CASE("automatic_stations__stand_inside_a_room_and_around_a_box") {
  const auto inside = automatic_stations(scene("room"));
  REQUIRE(inside.size() == 2);
  for (const ScanStation& station : inside) {
    const Vec3 p = station.pose.translation();
    CHECK((p.x > 0 && p.x < 6 && p.y > 0 && p.y < 5));
  }
  const auto around = automatic_stations(scene("box"));
  REQUIRE(around.size() == 4);
  for (const ScanStation& station : around) {
    const Vec3 p = station.pose.translation();
    CHECK((std::abs(p.x) > 2.1 + 1 && std::abs(p.y) > 0.9 + 1));
  }
}

TEST_CASE("automatic_stations__shift_with_the_model_and_need_something_upright") {
  Model model = scene("facade");
  const auto here = automatic_stations(model);
  const Vec3 shift{1024, -2048, 32};  // exact in the scene's doubles after the next line
  for (Vec3& v : model.vertices)
    v = Vec3{std::nearbyint(v.x * 0x1p20), std::nearbyint(v.y * 0x1p20),
             std::nearbyint(v.z * 0x1p20)} *
        0x1p-20;
  const auto snapped = automatic_stations(model);
  for (Vec3& v : model.vertices) v += shift;
  const auto there = automatic_stations(model);
  REQUIRE(there.size() == 2);
  for (size_t i = 0; i < 2; ++i)
    CHECK(norm(there[i].pose.translation() - snapped[i].pose.translation() - shift) < 1e-9);
  CHECK(here.size() == 2);

  CHECK(automatic_stations(Model{}).empty());
  Model floor;
  floor.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  floor.triangles = {{0, 1, 2}};
  floor.triangle_faces = {1};
  CHECK(automatic_stations(floor).empty());
}
