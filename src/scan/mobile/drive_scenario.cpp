// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/mobile/drive_scenario.h"

#include <numbers>

#include "base/setting_rows.h"
#include "model/buildings/building_tree.h"
#include "model/part_classes.h"
#include "model/trajectory/gauss_markov.h"
#include "scan/mobile/mobile_scan.h"
#include "scan/mobile/street_drive.h"

namespace jalon {

namespace {

using S = DriveScenarioSettings;
constexpr auto kDriveScenarioRows = setting_rows(
    integer_row<&S::scenario>(
        "scenario", 0, 5, "", "",
        "1: the trajectory is uncertain, 2: the blocks, 3: the facades, 4: the "
        "strips, 5: all; 0: by the sigmas below."),
    number_row<&S::sigma_block_m>("sigma_block_m", 0, 100, "m", "",
                                  "Scenario 0: standard deviation of blocks"),
    number_row<&S::sigma_facade_m>("sigma_facade_m", 0, 100, "m", "",
                                   "Scenario 0: standard deviation of facades"),
    number_row<&S::sigma_strip_m>("sigma_strip_m", 0, 100, "m", "",
                                  "Scenario 0: standard deviation of strips"),
    number_row<&S::sigma_trajectory_m>(
        "sigma_trajectory_m", 1e-6, 100, "m", "",
        "Scenario 0: standard deviation of the trajectory's positions"),
    number_row<&S::sigma_velocity_m_s>("sigma_velocity_m_s", 1e-9, 100, "m/s", "",
                                       "Of the trajectory's drift."),
    number_row<&S::control_s>("control_s", 0.01, 60, "s", "",
                              "From one error of the trajectory that is drawn to the next."),
    bool_row<&S::corner>("corner", "", "Two legs, in an L; else one, straight."),
    bool_row<&S::closed>("closed", "",
                         "With roofs, ground, and things before the houses that the model lacks."),
    number_row<&S::leg_m>("leg_m", 40, 10000, "m", "", "Length of a leg."),
    number_row<&S::width_m>("width_m", 0.05, 1000, "m", "", "Width of a strip."),
    number_row<&S::revolutions_per_s>("revolutions_per_s", 0.01, 1000, "1/s", "",
                                      "Turns of the scanner's mirror a second."),
    integer_row<&S::pulses>("pulses", 1, 1e6, "", "", "Pulses a revolution."),
    number_row<&S::noise_range_m>("noise_range_m", 0, 10, "m", "",
                                  "Standard deviation of the ranges drawn."),
    integer_row<&S::seed>("seed", 0, 1e15, "", "", "Of the errors and of the noise."));

// The street is the same for all seeds: only errors are drawn anew.
StreetDrive street_of(const DriveScenarioSettings& settings, const ScenarioSigmas& sigmas) {
  StreetDriveSettings street;
  street.leg_m = settings.leg_m;
  street.corner = settings.corner;
  street.closed = settings.closed;
  street.sigma_position_m = sigmas.trajectory_m;
  street.sigma_velocity_m_s = settings.sigma_velocity_m_s;
  return street_drive(street);
}

Model strips_of_street(const Model& street, const DriveScenarioSettings& settings, Task& task) {
  BuildingSettings strips;
  strips.width_m = settings.width_m;
  // Houses of a block turn out of line and leave gaps of some centimetres; blocks are 3 m apart.
  strips.touch_m = 2;
  const BuildingTree tree = building_tree(street, strips, task);
  Model made = strip_model(tree);
  if (settings.closed) add_others(made, tree, street);
  return made;
}

bool is_thing(const Model& street, const Face& face) {
  return street.parts[face.part].part_class == part_class::kElement;
}

// What a model does not know stays out of it: the things before the houses.
Model known_of(const Model& street) {
  Model known = street;
  std::erase_if(known.faces, [&](const Face& face) { return is_thing(street, face); });
  return known;
}

// The scene that is driven through: what the model knows, with its numbers, and the things.
Model scene_of(const Model& known, const Model& street) {
  Model scene = known;
  std::vector<uint8_t> is_thing_id(street.faces.size(), 0);
  for (const Face& face : street.faces) is_thing_id[face.id] = is_thing(street, face) ? 1 : 0;
  const auto first = static_cast<uint32_t>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), street.vertices.begin(), street.vertices.end());
  constexpr uint32_t kOfNoFace = 1u << 31;
  for (size_t t = 0; t < street.triangles.size(); ++t) {
    const uint32_t id = street.triangle_faces[t];
    if (is_thing_id[id] == 0) continue;
    const auto& [a, b, c] = street.triangles[t];
    scene.triangles.push_back({first + a, first + b, first + c});
    scene.triangle_faces.push_back(kOfNoFace + id);
  }
  return scene;
}

MobileSettings scanner_of(const DriveScenarioSettings& settings) {
  MobileSettings scanner;
  // The plane of the beams stands upright, turned so that fronts across the street are seen as well.
  scanner.mount.boresight_rad = {0, std::numbers::pi / 2, 0.4};
  scanner.mount.lever_arm_m = {0.5, 0.2, 1.8};
  scanner.revolutions_per_s = settings.revolutions_per_s;
  scanner.pulses = settings.pulses;
  scanner.noise_range_m = settings.noise_range_m;
  scanner.seed = settings.seed;
  return scanner;
}

Corrections drawn_errors_of(const Trajectory& trajectory, const DriveScenarioSettings& settings) {
  Corrections made{control_times(trajectory, settings.control_s), {}};
  const Trajectory controls = interpolated(trajectory, made.times_s);
  constexpr uint64_t kEast = 11, kNorth = 12;  // streams beside those of the model's draws
  const std::vector<double> x = drawn(position_prior(controls, 0), settings.seed, kEast),
                            y = drawn(position_prior(controls, 1), settings.seed, kNorth);
  for (size_t c = 0; c < x.size(); ++c) made.by_m.push_back({x[c], y[c]});
  return made;
}

// The same returns as a user has them, who knows the wrong trajectory alone.
Cloud seen_from(const Trajectory& wrong, const Cloud& truth, const GeoreferenceSettings& mount,
                Task& task) {
  const auto values = [&](const char* name) { return truth.fields.require(name).values<double>(); };
  Cloud made = georeferenced(
      wrong, {values("time"), values("range"), values("theta"), values("phi")}, mount, task);
  for (const ColumnPtr& column : truth.fields)
    if (made.fields.find(column->info().name) == nullptr) made.fields.set(column);
  return made;
}

}  // namespace

std::span<const ParamRow> drive_scenario_rows() { return kDriveScenarioRows; }

ScenarioSigmas sigmas_of(const DriveScenarioSettings& s) {
  if (s.scenario > 0) return kScenarioSigmas[static_cast<size_t>(s.scenario - 1)];
  return {s.sigma_block_m, s.sigma_facade_m, s.sigma_strip_m, s.sigma_trajectory_m};
}

DriveScenario drive_scenario(const DriveScenarioSettings& settings, Task& task) {
  const ScenarioSigmas sigmas = sigmas_of(settings);
  // 1. The street as it is.
  const StreetDrive street = street_of(settings, sigmas);
  DriveScenario made;
  made.true_model = strips_of_street(known_of(street.model), settings, task);
  made.true_trajectory = street.trajectory;
  const MobileSettings scanner = scanner_of(settings);
  const Cloud truth =
      scan_mobile(scene_of(made.true_model, street.model), made.true_trajectory, scanner, task);
  // 2. As it is known: a draw of all errors.
  made.offsets = drawn_offsets(made.true_model,
                               {sigmas.block_m, sigmas.facade_m, sigmas.strip_m, settings.seed});
  made.model = moved_strips(made.true_model, made.offsets);
  made.trajectory_errors = drawn_errors_of(made.true_trajectory, settings);
  made.trajectory = corrected(made.true_trajectory, made.trajectory_errors);
  made.cloud = seen_from(made.trajectory, truth, scanner.mount, task);
  return made;
}

}  // namespace jalon
