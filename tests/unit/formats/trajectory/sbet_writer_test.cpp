// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/formats/trajectory/flights.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// A bend with all sigmas, near Paris in Lambert-93.
Trajectory bend_in_paris(AxesConvention axes) {
  Trajectory t;
  t.axes = axes;
  for (int i = 0; i < 50; ++i) {
    t.times_s.push_back(i * 0.1);
    t.positions.push_back({652301 + 0.5 * i, 6861302 + 0.01 * i * i, 80 + 0.02 * i});
    t.attitudes_rad.push_back({0.01 * std::sin(i), -0.02, 0.3 + 0.02 * i});
    t.position_sigmas_m.push_back({0.02, 0.02, 0.05 + 0.001 * i});
    t.velocity_sigmas_m_s.push_back({0.01, 0.01, 0.02});
    t.attitude_sigmas_rad.push_back({1e-4, 1e-4, 3e-4});
  }
  return t;
}

}  // namespace

TEST_CASE("sbet__written_and_read__is_the_same_drive") {
  Folder folder;
  Task task;
  for (MapSystem system : {MapSystem::kUtm, MapSystem::kLambert93, MapSystem::kEnu})
    for (AxesConvention axes : {AxesConvention::kEnu, AxesConvention::kNed}) {
      Trajectory t = bend_in_paris(axes);
      TrajectoryFileSettings settings;
      settings.projection = system;
      if (system == MapSystem::kUtm) settings.utm_zone = 31;
      if (system == MapSystem::kEnu) {
        settings.origin = {48.85 * kDegreeOf, 2.35 * kDegreeOf, 30};
        for (Vec3& p : t.positions) p -= Vec3{652301, 6861302, 30};
      }
      const std::string path = folder.file("b.out"), sigmas = folder.file("s.out");
      write_trajectory(t, path, sigmas, settings, task);
      const Trajectory back = read_trajectory(path, sigmas, settings, task);
      CHECK(back.times_s == t.times_s);
      for (size_t i = 0; i < t.size(); ++i) {
        CHECK(norm(back.positions[i] - t.positions[i]) < 2e-6);
        const Matrix3 was = attitude_rotation(axes, t.attitudes_rad[i]) *
                            (axes == AxesConvention::kNed ? Matrix3{} : kForwardRightDown);
        const Matrix3 is = attitude_rotation(AxesConvention::kNed, back.attitudes_rad[i]);
        for (size_t k = 0; k < 9; ++k) CHECK(std::fabs(was.m[k] - is.m[k]) < 1e-12);
        CHECK(norm(back.position_sigmas_m[i] - t.position_sigmas_m[i]) < 1e-5);
        CHECK(norm(back.attitude_sigmas_rad[i] - t.attitude_sigmas_rad[i]) < 1e-12);
      }
    }
}

TEST_CASE("sbet__written_without_a_zone_or_sigmas__is_refused_and_leaves_no_file") {
  Folder folder;
  Task task;
  Trajectory t = bend_in_paris(AxesConvention::kEnu);
  const std::string path = folder.file("b.out");
  CHECK_THROWS_AS(write_trajectory(t, path, "", {}, task), Error);
  TrajectoryFileSettings settings;
  settings.projection = MapSystem::kLambert93;
  t.attitude_sigmas_rad.clear();
  CHECK_THROWS_AS(write_trajectory(t, path, folder.file("s.out"), settings, task), Error);
  CHECK(!std::filesystem::exists(path));
}
