// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "model/buildings/building_offsets.h"
#include "model/model.h"
#include "model/trajectory/corrections.h"

namespace jalon {

/// Standard deviations (m) of blocks, facades, strips and trajectory.
struct ScenarioSigmas {
  double block_m = 1, facade_m = 0.5, strip_m = 0.3, trajectory_m = 1;
};
/// The five of Monnier (2014): what is uncertain is the trajectory, the blocks, the facades, the strips, or a little of
/// everything.
inline constexpr std::array<ScenarioSigmas, 5> kScenarioSigmas{{{0.01, 0.01, 0.01, 2},
                                                                {2, 0.01, 0.01, 0.01},
                                                                {0.01, 2, 0.01, 0.01},
                                                                {0.01, 0.01, 2, 0.01},
                                                                {1, 0.5, 0.3, 1}}};

/// The settings of operation "drive_scenario".
struct DriveScenarioSettings {
  int64_t scenario = 5;
  double sigma_block_m = 1, sigma_facade_m = 0.5, sigma_strip_m = 0.3, sigma_trajectory_m = 1;
  double sigma_velocity_m_s = 0.01;  ///< what the printed spreads of Monnier (2014) bear out
  double control_s = 1;
  bool corner = true, closed = false;
  double leg_m = 132.5;
  double width_m = 1.5;
  double revolutions_per_s = 20;
  int64_t pulses = 500;
  double noise_range_m = 0;
  uint64_t seed = 1;
};
std::span<const ParamRow> drive_scenario_rows();
ScenarioSigmas sigmas_of(const DriveScenarioSettings& settings);

/// A drive through the street of street_drive.h, as a user has it and as it was.
struct DriveScenario {
  Model true_model,
      model;  ///< strips, with what else hides what is behind where the street is closed
  Trajectory true_trajectory, trajectory;  ///< with the scenario's sigmas
  Cloud cloud;  ///< as scan_mobile() gives it, its points where the wrong trajectory puts them
  BuildingOffsets offsets;        ///< of model from true_model
  Corrections trajectory_errors;  ///< of trajectory from true_trajectory
};
DriveScenario drive_scenario(const DriveScenarioSettings& settings, Task& task);

}  // namespace jalon
