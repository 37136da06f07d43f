// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "model/buildings/building_offsets.h"
#include "model/buildings/building_tree.h"
#include "model/trajectory/interpolation.h"
#include "registration/joint/strip_conditions.h"
#include "scan/mobile/mobile_scan.h"
#include "scan/mobile/street_drive.h"

namespace jalon {

/// The five scenarios of Monnier (2014): sigmas of blocks, facades, strips and trajectory (m).
struct JointScenario {
  double block, facade, strip, trajectory;
};
constexpr JointScenario kJointScenarios[] = {{0.01, 0.01, 0.01, 2},
                                             {2, 0.01, 0.01, 0.01},
                                             {0.01, 2, 0.01, 0.01},
                                             {0.01, 0.01, 2, 0.01},
                                             {1, 0.5, 0.3, 1}};

/// The L-shaped street in strips, driven through without error: perfect matches.
struct JointStreet {
  BuildingTree tree;
  Model strips;
  Trajectory drive;
  MobileSettings scanner;
  Cloud cloud;

  explicit JointStreet(uint64_t seed = 1) {
    StreetDriveSettings of;
    of.seed = seed;
    const StreetDrive street = street_drive(of);
    BuildingSettings settings;
    settings.touch_m = 2;
    Task task;
    tree = building_tree(street.model, settings, task);
    strips = strip_model(tree);
    drive = street.trajectory;
    scanner.mount.boresight_rad = {0, std::numbers::pi / 2, 0.4};
    scanner.mount.lever_arm_m = {0.5, 0.2, 1.8};
    scanner.mount.covariances = false;
    scanner.revolutions_per_s = 5, scanner.pulses = 360;
    cloud = scan_mobile(strips, drive, scanner, task);
  }

  std::vector<double> controls() const { return control_times(drive, 1); }
  MatchedPoints matches(const Cloud& points) const {
    return {points.xyz(), cloud.fields.require("time").values<double>(),
            cloud.fields.require("strip").values<uint32_t>()};
  }
  /// Where the strips of this model (of the street's strips, moved or not) are.
  std::vector<GivenStrip> given(const Model& moved) const {
    std::vector<GivenStrip> made;
    for (size_t s = 0; s < tree.strips.size(); ++s) {
      const BuildingFacade& f = tree.facades[tree.strips[s].facade];
      made.push_back({tree.block_of(f),
                      tree.strips[s].facade,
                      {f.normal.x, f.normal.y},
                      moved.faces[s].plane.offset});
    }
    return made;
  }
  /// Sigmas of the scenario, no strip conditions yet.
  JointProblem problem(const JointScenario& s) const {
    const std::vector<double> times = controls(), sigma(times.size(), s.trajectory),
                              velocity(times.size(), kDriftSigma_m_s);
    JointProblem made;
    made.x = made.y = gauss_markov(times, sigma, velocity);
    made.blocks = tree.blocks, made.facades = static_cast<uint32_t>(tree.facades.size());
    made.sigma_block_x_m = made.sigma_block_y_m = s.block;
    made.sigma_facade_m = s.facade, made.sigma_strip_m = s.strip;
    return made;
  }
  /// Of perfect points on the true model.
  StripConditions perfect_conditions() const {
    return strip_conditions(matches(cloud), given(strips), controls(), 1, 0);
  }
};

inline const JointStreet& joint_street() {
  static const JointStreet street;
  return street;
}

/// Errors of all observations, drawn from the priors of a problem, and the distances that they make.
struct JointErrors {
  std::vector<double> x, y;
  BuildingOffsets model;
};
inline JointErrors drawn_errors(const JointStreet& street, const JointProblem& problem,
                                uint64_t seed) {
  return {drawn(problem.x, seed, 11), drawn(problem.y, seed, 12),
          drawn_offsets(street.strips, {problem.sigma_block_x_m, problem.sigma_facade_m,
                                        problem.sigma_strip_m, seed})};
}
inline void set_distances(JointProblem& problem, const JointErrors& e,
                          const std::vector<uint32_t>& strip_of) {
  for (size_t s = 0; s < problem.strips.size(); ++s) {
    StripCondition& strip = problem.strips[s];
    const Vec2& b = e.model.blocks[strip.block];
    strip.distance_m = strip.normal.u * b.u + strip.normal.v * b.v + e.model.facades[strip.facade] +
                       e.model.strips[strip_of[s]];
    for (const auto& [c, share] : strip.shares)
      strip.distance_m -= share * (strip.normal.u * e.x[c] + strip.normal.v * e.y[c]);
  }
}

}  // namespace jalon
