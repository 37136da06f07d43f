// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "accuracy/seed_range.h"
#include "base/random.h"
#include "model/polygon_triangles.h"
#include "registration/joint/attitude_bias.h"
#include "registration/joint/joint_adjustment.h"
#include "model/buildings/building_tree.h"
#include "model/buildings/part_numbers.h"
#include "model/part_classes.h"
#include "model/trajectory/gauss_markov.h"
#include "scan/mobile/drive_scenario.h"
#include "scan/mobile/mobile_scan.h"
#include "scan/mobile/street_drive.h"

// What is left of the errors of a drive and a street that were drawn, after the adjustment.
namespace jalon::test {

enum LeftGroup : size_t { kOfTrajectory, kOfBlocks, kOfFacades, kOfStrips, kLeftGroups };
inline constexpr const char* kLeftNames[] = {"trajectory", "blocks", "facades", "strips"};

/// Root mean squares of errors, over draws and items.
struct Left {
  std::array<double, kLeftGroups> sums{}, counts{};

  void add(LeftGroup g, double e) { sums[g] += e * e, counts[g] += 1; }
  void add(LeftGroup g, const Vec2& e) { add(g, e.u), add(g, e.v); }
  double rms(size_t g) const { return std::sqrt(sums[g] / counts[g]); }
  void add(const Left& more) {
    for (size_t g = 0; g < kLeftGroups; ++g) sums[g] += more.sums[g], counts[g] += more.counts[g];
  }
};

/// Of strips those that were adjusted.
inline Left left_of(const JointAdjustment& a, const DriveScenario& s) {
  Left left;
  for (size_t c = 0; c < a.trajectory.by_m.size(); ++c)
    left.add(kOfTrajectory, s.trajectory_errors.by_m[c] + a.trajectory.by_m[c]);
  for (size_t b = 0; b < a.model.blocks.size(); ++b)
    left.add(kOfBlocks, s.offsets.blocks[b] + a.model.blocks[b]);
  std::vector<bool> seen(a.model.facades.size(), false);
  const std::vector<PartNumbers> numbers = part_numbers(s.model);
  for (const PartNumbers& n : numbers)
    if (n.strip != kNoStrip && a.strip_points[n.strip] > 0) seen[n.facade] = true;
  for (size_t f = 0; f < a.model.facades.size(); ++f)
    if (seen[f]) left.add(kOfFacades, s.offsets.facades[f] + a.model.facades[f]);
  for (size_t i = 0; i < a.model.strips.size(); ++i)
    if (a.strip_points[i] > 0) left.add(kOfStrips, s.offsets.strips[i] + a.model.strips[i]);
  return left;
}

/// A drive of its own kind through the street of street_drive.h, closed: one street for all seeds, or each its own.
struct DriveKind {
  ScenarioSigmas sigmas = kScenarioSigmas[4];
  uint64_t seed = 1;
  double covered =
      0;  ///< share of the kerbs with things 5 m high before the houses, which the model lacks
  bool corner = true, there_and_back = false;
  double mask_sigma_m = 0;  ///< of the positions amid a gap of satellites; 0: none
  double noise_range_m = 0.005;
  double sigma_height_m = 0;  ///< of the drive; 0: its heights are right and the ground is as it is
  double sigma_ground_m = 0.1, ground_correlation_m = 25;
  Vec3 sigma_attitude_rad;  ///< of constant errors about the vehicle's axes
  bool own_street = false;  ///< lengths of blocks, set-backs, turns and heights by the seed
};

/// Turns at the end, within four seconds, and drives back.
inline void add_way_back(Trajectory& drive) {
  const size_t n = drive.size();
  const double end_s = drive.times_s.back();
  constexpr double kTurning_s = 4;
  const auto add = [&](size_t as, double time_s, double turned) {
    drive.times_s.push_back(time_s);
    drive.positions.push_back(drive.positions[as]);
    drive.attitudes_rad.push_back(drive.attitudes_rad[as]);
    drive.attitudes_rad.back().z += turned;
    drive.position_sigmas_m.push_back(drive.position_sigmas_m[as]);
    drive.velocity_sigmas_m_s.push_back(drive.velocity_sigmas_m_s[as]);
    drive.attitude_sigmas_rad.push_back(drive.attitude_sigmas_rad[as]);
  };
  constexpr int kTurningSteps = 40;
  for (int k = 1; k < kTurningSteps; ++k)
    add(n - 1, end_s + kTurning_s * k / kTurningSteps, std::numbers::pi * k / kTurningSteps);
  for (size_t i = n; i-- > 0;)
    add(i, end_s + kTurning_s + end_s - drive.times_s[i], std::numbers::pi);
}

/// From a third of the drive on positions are ever less sure, until halfway to its second third.
inline void mask_satellites(Trajectory& drive, double sigma_m) {
  const double all = drive.times_s.back();
  for (size_t i = 0; i < drive.size(); ++i) {
    const double off = std::fabs(drive.times_s[i] / all - 0.5) * 6;  // 1 at the thirds
    const double more = std::max(0.0, 1 - off) * sigma_m;
    drive.position_sigmas_m[i] = drive.position_sigmas_m[i] + Vec3{more, more, more};
  }
}

inline void add_box(Model& scene, const Vec3& low, const Vec3& high) {
  const auto first = static_cast<uint32_t>(scene.vertices.size());
  for (const double z : {low.z, high.z})
    for (const Vec2& p :
         {Vec2{low.x, low.y}, Vec2{high.x, low.y}, Vec2{high.x, high.y}, Vec2{low.x, high.y}})
      scene.vertices.push_back({p.u, p.v, z});
  constexpr uint32_t kOfNoFace = 1u << 31;
  for (uint32_t k = 0; k < 4; ++k) {
    const uint32_t a = first + k, b = first + (k + 1) % 4;
    scene.triangles.push_back({a, b, b + 4}), scene.triangles.push_back({a, b + 4, a + 4});
    scene.triangle_faces.insert(scene.triangle_faces.end(), {kOfNoFace, kOfNoFace});
  }
}

inline void cover_kerbs(Model& scene, double leg_m, bool corner, double share) {
  constexpr double kEvery_m = 10, kHigh_m = 5;
  for (const double side : {-1.0, 1.0}) {
    const double near = side * 5.5 - 0.5, far = near + 1;
    for (double x = 5; x + kEvery_m < leg_m - 10; x += kEvery_m)
      add_box(scene, {x, near, 0}, {x + share * kEvery_m, far, kHigh_m});
    if (corner)
      for (double y = 10; y + kEvery_m < leg_m; y += kEvery_m)
        add_box(scene, {leg_m + near, y, 0}, {leg_m + far, y + share * kEvery_m, kHigh_m});
  }
}

/// How far the attitudes of a drive are off: by a constant, about the vehicle's axes.
inline Vec3 attitude_error(const DriveKind& kind) {
  RandomStream random(kind.seed, 31);
  Vec3 made;
  for (int k = 0; k < 3; ++k) made[k] = kind.sigma_attitude_rad[k] * random.normal();
  return made;
}

/// The ground of a model in place of its own, off by a chain along the way driven: x, then y.
inline void bend_ground(Model& model, double sigma_m, double correlation_m, uint64_t seed) {
  constexpr double kStep_m = 1, kFrom_m = -60, kTo_m = 340, kAside_m = 340;
  const auto is_ground = [&](const Face& face) {
    return model.parts[face.part].part_class == part_class::kGround;
  };
  const auto ground = std::ranges::find_if(model.faces, is_ground);
  const uint32_t part = ground->part;
  std::erase_if(model.faces, is_ground);
  std::vector<Vec3> ways;
  for (double s = kFrom_m; s <= kTo_m; s += kStep_m) ways.push_back({s, 0, 0});
  const std::vector<double> z = drawn(ground_chain(ways, sigma_m, correlation_m), seed, 33);
  const auto place = [&](size_t i, double aside) {
    return Vec3{(ways[i].x + aside) / 2, (ways[i].x - aside) / 2, z[i]};
  };
  for (size_t i = 0; i + 1 < ways.size(); ++i) {
    const std::vector<Vec3> corners{place(i, -kAside_m), place(i, kAside_m), place(i + 1, kAside_m),
                                    place(i + 1, -kAside_m)};
    Face face;
    face.part = part;
    face.id = static_cast<uint32_t>(model.faces.size());
    face.plane.normal = normalized(newell_normal(corners));
    face.plane.offset = dot(face.plane.normal, corners[0]);
    model.add_face(face, {corners});
  }
}

inline DriveScenario driven(const DriveKind& kind, Task& task) {
  // 1. The street, the drive, and what the model knows of them.
  StreetDriveSettings of;
  of.closed = true, of.corner = kind.corner;
  if (kind.own_street) {
    constexpr double kShortest = 0.75, kLongest = 1.25;  // houses of 5.4 to 9.6 m
    of.seed = kind.seed;
    of.leg_m *= kShortest + (kLongest - kShortest) * RandomStream(kind.seed, 41).uniform();
  }
  of.sigma_position_m = kind.sigmas.trajectory_m;
  StreetDrive street = street_drive(of);
  if (kind.there_and_back) add_way_back(street.trajectory);
  if (kind.mask_sigma_m > 0) mask_satellites(street.trajectory, kind.mask_sigma_m);
  Model known = street.model;
  std::erase_if(known.faces, [&](const Face& face) {
    return known.parts[face.part].part_class == part_class::kElement;
  });
  BuildingSettings strips;
  strips.touch_m = 2;
  const BuildingTree tree = building_tree(known, strips, task);
  DriveScenario made;
  made.true_model = strip_model(tree);
  add_others(made.true_model, tree, known);
  made.true_trajectory = street.trajectory;
  // 2. What the laser sees.
  Model scene = made.true_model;
  if (kind.covered > 0) cover_kerbs(scene, of.leg_m, kind.corner, kind.covered);
  MobileSettings scanner;
  scanner.mount.boresight_rad = {0, std::numbers::pi / 2, 0.4};
  scanner.mount.lever_arm_m = {0.5, 0.2, 1.8};
  scanner.revolutions_per_s = 10, scanner.pulses = 250;
  scanner.noise_range_m = kind.noise_range_m, scanner.seed = kind.seed;
  const Cloud truth = scan_mobile(scene, made.true_trajectory, scanner, task);
  // 3. As it is known.
  made.offsets = drawn_offsets(
      made.true_model, {kind.sigmas.block_m, kind.sigmas.facade_m, kind.sigmas.strip_m, kind.seed});
  made.model = moved_strips(made.true_model, made.offsets);
  made.trajectory_errors = {control_times(made.true_trajectory, 1), {}};
  const Trajectory controls = interpolated(made.true_trajectory, made.trajectory_errors.times_s);
  const std::vector<double> x = drawn(position_prior(controls, 0), kind.seed, 11),
                            y = drawn(position_prior(controls, 1), kind.seed, 12);
  for (size_t c = 0; c < x.size(); ++c) made.trajectory_errors.by_m.push_back({x[c], y[c]});
  made.trajectory =
      turned(corrected(made.true_trajectory, made.trajectory_errors), attitude_error(kind));
  const auto values = [&](const char* name) { return truth.fields.require(name).values<double>(); };
  if (kind.sigma_height_m > 0) {
    for (Vec3& p : made.trajectory.position_sigmas_m) p.z = kind.sigma_height_m;
    const Trajectory unsure = interpolated(made.trajectory, made.trajectory_errors.times_s);
    const std::vector<double> z = drawn(position_prior(unsure, 2), kind.seed, 13);
    TimePlace at;
    for (size_t i = 0; i < made.trajectory.size(); ++i) {
      at = time_place(unsure.times_s, made.trajectory.times_s[i], i, at.epoch);
      made.trajectory.positions[i].z += z[at.epoch] * (1 - at.share) + z[at.epoch + 1] * at.share;
    }
    bend_ground(made.model, kind.sigma_ground_m, kind.ground_correlation_m, kind.seed);
  }
  made.cloud = georeferenced(made.trajectory,
                             {values("time"), values("range"), values("theta"), values("phi")},
                             scanner.mount, task);
  for (const ColumnPtr& column : truth.fields)
    if (made.cloud.fields.find(column->info().name) == nullptr) made.cloud.fields.set(column);
  return made;
}

inline JointSettings settings_of(const ScenarioSigmas& sigmas) {
  JointSettings made;
  made.sigma_block_x_m = made.sigma_block_y_m = sigmas.block_m;
  made.sigma_facade_m = sigmas.facade_m, made.sigma_strip_m = sigmas.strip_m;
  return made;
}

/// Of the points whose rays were cast, those on things that the model lacks.
inline double clutter_of(const JointAdjustment& a) {
  double n = 0;
  for (const uint32_t id : a.points.id) n += id == kNoStrip ? 1 : 0;
  return n / static_cast<double>(a.points.id.size());
}

}  // namespace jalon::test
