// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/trajectory/trajectory_text.h"

#include <doctest/doctest.h>

#include "unit/formats/trajectory/flights.h"
#include "unit/model/trajectory/drives.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("trajectory_text__written_and_read__gives_the_same_bits") {
  Folder folder;
  Task task;
  Trajectory drive = bent_drive(30, 0.37);
  drive.axes = AxesConvention::kNed;
  for (const Vec3& p : drive.positions) drive.velocities_m_s.push_back(p * 1e-6);
  const std::string path = folder.file("drive.txt");
  write_trajectory(drive, path, "", {}, task);
  const Trajectory back = read_trajectory(path, "", {}, task);
  CHECK(back.times_s == drive.times_s);
  CHECK(back.positions == drive.positions);
  CHECK(back.attitudes_rad == drive.attitudes_rad);
  CHECK(back.velocities_m_s == drive.velocities_m_s);
  CHECK(back.position_sigmas_m == drive.position_sigmas_m);
  CHECK(back.velocity_sigmas_m_s == drive.velocity_sigmas_m_s);
  CHECK(back.attitude_sigmas_rad == drive.attitude_sigmas_rad);
  CHECK(back.axes == AxesConvention::kNed);
  CHECK(back.crs == "EPSG:2154");
}

TEST_CASE("trajectory_text__of_others__takes_names_in_any_order_degrees_and_separators") {
  Folder folder;
  Task task;
  const std::string path = folder.file("log.csv");
  spill(path,
        "Time,Heading_deg,roll_deg,pitch_deg,y,x,z,quality\r\n10, 90,1,-2, 5,4,3, "
        "1\r\n\n11;180;0;0;6;4;3;0\n");
  TrajectoryFileSettings settings;
  settings.axes = AxesConvention::kNed;
  const Trajectory made = read_trajectory(path, "", settings, task);
  CHECK(made.axes == AxesConvention::kNed);
  CHECK(norm(made.attitudes_rad[0] - Vec3{1, -2, 90} * kDegreeOf) < 1e-15);
  CHECK(made.positions[1] == Vec3{4, 6, 3});
  CHECK(made.position_sigmas_m.empty());
}

TEST_CASE("trajectory_text__that_is_wrong__is_refused_with_line_and_column") {
  Folder folder;
  const std::string path = folder.file("log.txt");
  const auto of = [&](const std::string& text) {
    spill(path, text);
    return refusal_of_reading(path);
  };
  const std::string head = "time x y z roll pitch yaw\n";
  CHECK(of(head + "1 0 0 0 0 0 0\n2 0 nan 0 0 0 0\n") == "line 3: column \"y\": nan is no number");
  CHECK(of(head + "1 0 0 0 0 0 0\n2 0 0 0 0 0\n") == "line 3: 6 values under 7 names");
  CHECK(of(head + "1 0 0 0 0 0 0\n1 0 0 0 0 0 0\n") ==
        "line 3: time 1 is not after time 1 of the epoch before");
  CHECK(of("time x y z roll pitch yaw sx sy sz\n1 0 0 0 0 0 0 1 0 1\n") ==
        "line 2: column \"sy\" is 0; a standard deviation must be positive");
  CHECK(of("time x y z roll pitch\n") ==
        "line 1: columns \"roll\", \"pitch\", \"yaw\" go together: 2 of them are there");
  CHECK(of("x y z roll pitch yaw\n") == "line 1: one column \"time\" is needed");
  CHECK(of("time x y z roll pitch yaw yaw_deg\n") == "line 1: column \"yaw\" is there twice");
  CHECK(of("# axes flu\n" + head) == "line 1: axes are enu or ned, not flu");
  CHECK(of(head + "1 0 0 0 0 0 0\n") == "a trajectory of 1 epochs: two are needed");
  CHECK(of("") == "no line names the columns: time x y z roll pitch yaw ...");
}
