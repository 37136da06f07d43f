// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "accuracy/joint_drives.h"
#include "geometry/rigid_motion.h"

// An adjustment of drive, buildings, attitudes and heights of the same scan whose points are jittered, rounded,
// reversed, halved, turned or moved to a national grid: by how many of their standard deviations results change.

namespace jalon::joint_stability_test {

using namespace jalon::test;

namespace {

struct Given {
  Model model;
  Trajectory drive;
  Cloud cloud;
  double turned_rad = 0;  ///< about the vertical axis, from the scan that others are compared with
};

std::vector<double> values_of(const Cloud& cloud, const char* name) {
  const auto v = cloud.fields.require(name).values<double>();
  return {v.begin(), v.end()};
}

Cloud seen_from(const Trajectory& drive, const Cloud& scan, const std::vector<double>& ranges,
                Task& task) {
  GeoreferenceSettings mount;
  mount.boresight_rad = {0, std::numbers::pi / 2, 0.4};
  mount.lever_arm_m = {0.5, 0.2, 1.8};
  return georeferenced(
      drive, {values_of(scan, "time"), ranges, values_of(scan, "theta"), values_of(scan, "phi")},
      mount, task);
}

Given jittered(const Given& g, Task& task) {
  std::vector<double> ranges = values_of(g.cloud, "range");
  RandomStream random(5, 1);
  for (double& r : ranges) r += 0.0005 * random.normal();
  return {g.model, g.drive, seen_from(g.drive, g.cloud, ranges, task)};
}

Given rounded(const Given& g, Task&) {
  Buffer<double> xyz(3 * g.cloud.size());
  for (size_t i = 0; i < xyz.size(); ++i) xyz[i] = std::round(1000 * g.cloud.xyz()[i]) / 1000;
  Given made{g.model, g.drive, make_cloud(std::move(xyz))};
  made.cloud.fields = g.cloud.fields;
  return made;
}

Given with_points(const Given& g, uint64_t first, int64_t step, uint64_t count, Task& task) {
  std::vector<uint64_t> index;
  for (uint64_t k = 0; k < count; ++k)
    index.push_back(
        static_cast<uint64_t>(static_cast<int64_t>(first) + step * static_cast<int64_t>(k)));
  return {g.model, g.drive, select(g.cloud, index, task)};
}
Given reversed(const Given& g, Task& task) {
  return with_points(g, g.cloud.size() - 1, -1, g.cloud.size(), task);
}
Given halved(const Given& g, Task& task) { return with_points(g, 0, 2, g.cloud.size() / 2, task); }

Given moved(const Given& g, double turn_rad, const Vec3& shift, Task& task) {
  const Transform by = motion_about({}, {0, 0, turn_rad}, shift);
  Given made = g;
  made.turned_rad = turn_rad;
  for (Vec3& v : made.model.vertices) v = by.point(v);
  for (Face& face : made.model.faces) {
    face.plane.normal = by.direction(face.plane.normal);
    face.plane.offset += dot(face.plane.normal, shift);
  }
  for (Vec3& p : made.drive.positions) p = by.point(p);
  for (Vec3& a : made.drive.attitudes_rad) a.z += turn_rad;
  made.cloud = seen_from(made.drive, g.cloud, values_of(g.cloud, "range"), task);
  return made;
}
Given turned_street(const Given& g, Task& task) { return moved(g, 0.5, {}, task); }
Given in_national_grid(const Given& g, Task& task) {
  return moved(g, 0, {652000, 6861000, 35}, task);
}

JointAdjustment adjusted(const Given& g, Task& task) {
  JointSettings by = settings_of({0.05, 0.05, 0.05, 0.05});
  by.sigma_roll_bias_rad = by.sigma_pitch_bias_rad = by.sigma_heading_bias_rad = 0.009;
  by.sigma_ground_m = 0.1;
  return adjust_jointly(g.model, g.cloud, g.drive, by, task);
}

struct Changes {
  double drive = 0, attitude = 0, heights = 0;  ///< in standard deviations, at most
};
Changes between_results(const JointAdjustment& a, const JointAdjustment& b, double turned_rad) {
  Changes made;
  const double c = std::cos(turned_rad), s = std::sin(turned_rad);
  for (size_t i = 0; i < a.trajectory.by_m.size(); ++i) {
    const Vec2 p = a.trajectory.by_m[i], q = b.trajectory.by_m[i], sigma = a.trajectory_sigmas[i];
    const Vec2 off = Vec2{c * p.u - s * p.v, s * p.u + c * p.v} - q;
    made.drive = std::max(made.drive, norm(off) / std::min(sigma.u, sigma.v));
    made.heights =
        std::max(made.heights, std::fabs(a.heights_m[i] - b.heights_m[i]) / a.height_sigmas_m[i]);
  }
  for (int k = 0; k < 3; ++k)
    made.attitude =
        std::max(made.attitude, std::fabs(a.attitude_bias_rad[k] - b.attitude_bias_rad[k]) /
                                    a.attitude_bias_sigmas_rad[k]);
  return made;
}

}  // namespace

TEST_CASE("joint_stability__of_points_that_are_given_otherwise__is_within_standard_deviations" *
          doctest::skip(std::getenv("JALON_FULL") == nullptr)) {
  struct Change {
    const char* name;
    Given (*make)(const Given&, Task&);
  };
  const Change changes[] = {{"jittered by a tenth of the noise", jittered},
                            {"rounded to millimetres", rounded},
                            {"reversed", reversed},
                            {"halved", halved},
                            {"turned", turned_street},
                            {"in the national grid", in_national_grid}};
  Task task;
  std::vector<Given> drives;
  std::vector<JointAdjustment> results;
  for (const uint64_t seed : {9471, 9472, 9473}) {
    DriveKind kind;
    kind.sigmas = {0.05, 0.05, 0.05, 0.05};
    kind.sigma_attitude_rad = {0.009, 0.009, 0.009};
    kind.sigma_height_m = 0.5;
    kind.seed = seed;
    DriveScenario made = driven(kind, task);
    drives.push_back({std::move(made.model), std::move(made.trajectory), std::move(made.cloud)});
    results.push_back(adjusted(drives.back(), task));
  }
  for (const Change& change : changes) {
    Changes most;
    for (size_t i = 0; i < drives.size(); ++i) {
      const Given other = change.make(drives[i], task);
      const Changes one = between_results(results[i], adjusted(other, task), other.turned_rad);
      most.drive = std::max(most.drive, one.drive);
      most.attitude = std::max(most.attitude, one.attitude);
      most.heights = std::max(most.heights, one.heights);
    }
    MESSAGE("FIGURE joint stability, ", drives.size(), " drives ", std::string(change.name),
            ": in standard deviations drive ", most.drive, ", attitudes ", most.attitude,
            ", heights ", most.heights);
    CHECK(std::max({most.drive, most.attitude, most.heights}) < 1);
  }
}

}  // namespace jalon::joint_stability_test
