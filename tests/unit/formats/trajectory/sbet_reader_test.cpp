// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/trajectory/sbet.h"

#include <doctest/doctest.h>

#include "model/trajectory/interpolation.h"
#include "unit/formats/trajectory/flights.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("sbet__driven_northwards__looks_where_it_goes_on_every_map") {
  Folder folder;
  const std::string path = folder.file("sbet.out");
  spill(path, bytes_of(northwards(300)));
  Task task;
  for (MapSystem system : {MapSystem::kUtm, MapSystem::kLambert93, MapSystem::kEnu}) {
    TrajectoryFileSettings settings;
    settings.projection = system;
    if (system == MapSystem::kEnu) settings.origin = {48.8 * kDegreeOf, 2.2 * kDegreeOf, 0};
    const Trajectory made = read_trajectory(path, "", settings, task);
    REQUIRE(made.size() == 300);
    const Vec3 way = normalized(made.positions[299] - made.positions[0]);
    // The level way ahead, roll and pitch taken back, is the way that it goes; up to what the map's
    // own bend makes of 30 m.
    const Matrix3 stand = attitude_rotation(made.axes, made.attitudes_rad[150]);
    const Vec3 ahead = stand * (rotation_x(-0.01) * (rotation_y(0.02) * Vec3{1, 0, 0}));
    const Vec3 nose = stand * Vec3{1, 0, 0};
    CHECK(norm(ahead - way) < 1e-5);
    if (system != MapSystem::kEnu) {
      CHECK(nose.z == doctest::Approx(std::sin(-0.02)));
      CHECK(std::fabs(way.x) > 0.008);  // grid north is not true north
    }
  }
}

TEST_CASE("sbet__in_paris__lies_where_proj_puts_it_in_the_named_system") {
  Folder folder;
  const std::string path = folder.file("sbet.sbet");
  spill(path, bytes_of(northwards(5)));
  Task task;
  TrajectoryFileSettings settings;
  Trajectory made = read_trajectory(path, "", settings, task);
  CHECK(norm(made.positions[0] - Vec3{452314.89123, 5410984.88760, 80}) < 2e-5);
  CHECK(made.crs == "EPSG:32631");
  CHECK(made.axes == AxesConvention::kNed);
  CHECK(made.attitudes_rad[0].z == doctest::Approx(0.4894523061 * kDegreeOf));
  CHECK(made.attitudes_rad[0].x == doctest::Approx(0.01));
  settings.projection = MapSystem::kLambert93;
  settings.heading = SbetHeading::kTrue;
  made = read_trajectory(path, "", settings, task);
  CHECK(norm(made.positions[0] - Vec3{652301.56483, 6861302.72590, 80}) < 2e-5);
  CHECK(made.crs == "EPSG:2154");
  CHECK(made.attitudes_rad[0].z == doctest::Approx(0.3 + 0.4716450473 * kDegreeOf));
  settings.heading = SbetHeading::kPlusWander;
  CHECK(read_trajectory(path, "", settings, task).attitudes_rad[0].z ==
        doctest::Approx(0.6 + 0.4716450473 * kDegreeOf));
}

TEST_CASE("sbet__damaged__is_refused_with_record_and_field") {
  Folder folder;
  const std::string path = folder.file("sbet.out");
  const auto with = [&](auto change) {
    auto lines = northwards(20);
    change(lines);
    spill(path, bytes_of(lines));
    return refusal_of_reading(path);
  };
  CHECK(with([](auto& l) { l[7][kSbetLatitude] = std::nan(""); }) ==
        "offset 960: record 7: latitude is nan");
  CHECK(with([](auto& l) { l[3][kSbetTime] = 345600; }) ==
        "offset 408: record 3: time is 345600, not after that of the record before, 345600.02");
  CHECK(with([](auto& l) { l[2][kSbetLatitude] = 48.85; }) ==
        "offset 280: record 2: latitude is 48.85, beyond a right angle");
  CHECK(with([](auto& l) { l[19][kSbetPitch] = 2; }) ==
        "offset 2648: record 19: pitch is 2, beyond a right angle");
  CHECK(with([](auto& l) { l.resize(1); }) == "a trajectory of 1 records: two are needed");
  const std::string whole = bytes_of(northwards(20));
  spill(path, whole.substr(0, whole.size() - 40));
  CHECK(refusal_of_reading(path) ==
        "offset 2584: record 19 is cut off: 96 of its 136 bytes are there");
}

TEST_CASE("sbet__origin_of_two_numbers__is_refused") {
  Folder folder;
  const std::string path = folder.file("sbet.out");
  spill(path, bytes_of(northwards(5)));
  TrajectoryFileSettings settings;
  settings.projection = MapSystem::kEnu;
  settings.origin = {0.85, 0.04};
  Task task;
  CHECK_THROWS_AS(read_trajectory(path, "", settings, task), Error);
  settings.origin = {48.85, 2.35, 0};
  CHECK_THROWS_AS(read_trajectory(path, "", settings, task), Error);
}
