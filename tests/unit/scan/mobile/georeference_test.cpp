// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/mobile/georeference.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "base/random.h"
#include "unit/model/trajectory/drives.h"

using namespace jalon;

namespace {

struct SomeReturns {
  std::vector<double> times, ranges, thetas, phis;
  LaserReturns view() const { return {times, ranges, thetas, phis}; }
};

SomeReturns some_returns(size_t n) {
  RandomStream random(8, 0);
  SomeReturns made;
  for (size_t i = 0; i < n; ++i) {
    made.times.push_back(1000 + 9 * random.uniform());
    made.ranges.push_back(5 + 40 * random.uniform());
    made.thetas.push_back(6 * random.uniform());
    made.phis.push_back(0.2 + 2.7 * random.uniform());
  }
  return made;
}

GeoreferenceSettings mounted() {
  GeoreferenceSettings settings;
  settings.mirror_offset_m = {0.01, -0.02, 0.03};
  settings.boresight_rad = {0.01, -0.5, 0.7};
  settings.lever_arm_m = {0.5, 0.2, 1.8};
  return settings;
}

std::string refusal_of_returns(const SomeReturns& returns, const Trajectory& drive,
                               const GeoreferenceSettings& settings = {}) {
  Task task;
  try {
    georeferenced(drive, returns.view(), settings, task);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("georeferenced__returns_at_any_time__lie_and_are_worth_what_the_equation_says") {
  Trajectory drive = bent_drive(10);
  const SomeReturns returns = some_returns(300);
  for (AxesConvention axes : {AxesConvention::kEnu, AxesConvention::kNed}) {
    drive.axes = axes;
    Task task;
    const Cloud cloud = georeferenced(drive, returns.view(), mounted(), task);
    REQUIRE(cloud.size() == 300);
    CHECK(cloud.crs == "EPSG:2154");
    const auto origins = cloud.fields.require("beam_origin").values<double>();
    const auto ways = cloud.fields.require("beam_direction").values<float>();
    const auto covariances = cloud.fields.require("covariance").values<float>();
    const PoseInterpolator poses(drive);
    const BeamGeometry geometry(mount_of(mounted()));
    for (size_t i = 0; i < 300; ++i) {
      const TimePlace at = time_place(drive.times_s, returns.times[i], i);
      const VehiclePose pose =
          vehicle_pose(poses.rotation(at), poses.position(at), axes == AxesConvention::kNed);
      const LaserReturn from{returns.ranges[i], returns.thetas[i], returns.phis[i]};
      const WorldBeam beam = geometry.beam(from, pose);
      CHECK(cloud.point(i) == beam.point);
      CHECK(origins[3 * i + 1] == beam.origin.y);
      CHECK(ways[3 * i + 2] == static_cast<float>(beam.direction.z));
      LaserSigmas sigmas = laser_sigmas(mounted());
      set_pose_sigmas(sigmas, drive, at);
      const Symmetric3 c = geometry.covariance(from, pose, sigmas);
      for (size_t k = 0; k < 6; ++k) CHECK(covariances[6 * i + k] == static_cast<float>(c[k]));
    }
  }
}

TEST_CASE("georeferenced__with_any_number_of_threads__gives_the_same_bits") {
  const Trajectory drive = bent_drive(10);
  const SomeReturns returns = some_returns(100000);
  Task::Hooks one, four;
  one.threads = 1, four.threads = 4;
  Task a(one), b(four);
  const Cloud single = georeferenced(drive, returns.view(), mounted(), a),
              many = georeferenced(drive, returns.view(), mounted(), b);
  CHECK(std::equal(single.xyz().begin(), single.xyz().end(), many.xyz().begin()));
  const auto c1 = single.fields.require("covariance").values<float>(),
             c4 = many.fields.require("covariance").values<float>();
  CHECK(std::equal(c1.begin(), c1.end(), c4.begin()));
}

TEST_CASE("georeferenced__impossible_returns__are_refused_with_their_number") {
  const Trajectory drive = bent_drive(10);
  SomeReturns returns = some_returns(10);
  returns.ranges[4] = 0;
  CHECK(refusal_of_returns(returns, drive) == "return 4: the range is 0");
  returns = some_returns(10);
  returns.phis[9] = std::nan("");
  CHECK(refusal_of_returns(returns, drive) == "return 9: phi is nan");
  returns = some_returns(10);
  returns.times[2] = 1009.5;
  CHECK(refusal_of_returns(returns, drive) ==
        "time 1009.5 of item 2 is outside of the trajectory, which lasts from 1000 to 1009");
  GeoreferenceSettings settings;
  settings.lever_arm_m = {1, 2};
  CHECK(refusal_of_returns(some_returns(3), drive, settings) ==
        "lever_arm_m needs three numbers, not 2");
}

TEST_CASE("georeferenced__without_sigmas_of_the_drive__needs_to_be_told_so") {
  Trajectory drive = bent_drive(10);
  drive.attitude_sigmas_rad.clear();
  CHECK(refusal_of_returns(some_returns(3), drive).find("no sigmas of attitude") !=
        std::string::npos);
  GeoreferenceSettings settings;
  settings.covariances = false;
  Task task;
  const Cloud cloud = georeferenced(drive, some_returns(3).view(), settings, task);
  CHECK(cloud.fields.find("covariance") == nullptr);
  CHECK(cloud.fields.find("beam_origin") != nullptr);
}
