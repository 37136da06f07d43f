// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/inputs/drive_scan.h"

#include <filesystem>
#include <numbers>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/output_check.h"

namespace jalon::cli {

namespace {

using DriveJson = nlohmann::ordered_json;

std::vector<double> column(const Fields& fields, const char* name) {
  jalon_array_view view;
  must(jalon_fields_view(fields.get(), name, &view));
  std::vector<double> made(view.count * view.components);
  must(jalon_fields_copy(fields.get(), name, JALON_FLOAT64, made.data(), made.size()));
  return made;
}

Fields epochs_of(const Trajectory& trajectory) {
  Fields made;
  must(jalon_trajectory_epochs(trajectory.get(), Out(made)));
  return made;
}

// Houses with roofs, ground, and vans and kiosks before them.
Params street_options(const Settings& told) {
  Params options = make_params("street_drive");
  must(jalon_params_set_bool(options.get(), "closed", 1));
  told.apply(options.get());
  return options;
}

// A plane scanner on the roof: its beams go up and down, aslant so that walls across the street are seen.
Scanner mobile_scanner(const Settings& told, Params& params) {
  Scanner made;
  must(jalon_scanner_create("mobile", Out(made)));
  must(jalon_scanner_params(made.get(), Out(params)));
  const double boresight[] = {0, std::numbers::pi / 2, 0.4}, arm[] = {0.5, 0.2, 1.8};
  must(jalon_params_set_doubles(params.get(), "boresight_rad", boresight, 3));
  must(jalon_params_set_doubles(params.get(), "lever_arm_m", arm, 3));
  must(jalon_params_set_double(params.get(), "revolutions_per_s", 20));
  must(jalon_params_set_int64(params.get(), "pulses", 500));
  must(jalon_params_set_double(params.get(), "noise_range_m", 0.005));
  told.apply(params.get());
  return made;
}

// The trajectory with a draw of its errors: one a second, linear between, as its prior has them.
Trajectory with_drift(const Trajectory& truth, int64_t seed) {
  constexpr double kControl_s = 1;
  const Fields epochs = epochs_of(truth);
  const std::vector<double> times = column(epochs, "time");
  Trajectory controls, drawn, between, drawn_between, made;
  must(jalon_trajectory_control(truth.get(), kControl_s, Out(controls)));
  must(jalon_trajectory_perturb(controls.get(), static_cast<uint64_t>(seed), Out(drawn)));
  must(jalon_trajectory_interpolate(controls.get(), times.data(), times.size(), Out(between)));
  must(jalon_trajectory_interpolate(drawn.get(), times.data(), times.size(), Out(drawn_between)));
  std::vector<double> xyz = column(epochs, "xyz");
  const std::vector<double> was = column(epochs_of(between), "xyz"),
                            is = column(epochs_of(drawn_between), "xyz");
  for (size_t i = 0; i < xyz.size(); ++i) xyz[i] += is[i] - was[i];
  const std::vector<double> attitude = column(epochs, "attitude"),
                            position_sigma = column(epochs, "position_sigma"),
                            velocity_sigma = column(epochs, "velocity_sigma"),
                            attitude_sigma = column(epochs, "attitude_sigma");
  must(jalon_trajectory_create(times.data(), xyz.data(), attitude.data(), position_sigma.data(),
                               velocity_sigma.data(), attitude_sigma.data(), times.size(), nullptr,
                               nullptr, Out(made)));
  return made;
}

// What was measured, as points of this trajectory.
Cloud points_of(const Cloud& measured, const Trajectory& trajectory, const Params& scanner,
                jalon_task* task) {
  Fields fields;
  must(jalon_cloud_fields(measured.get(), Out(fields)));
  const std::vector<double> times = column(fields, "time"), ranges = column(fields, "range"),
                            thetas = column(fields, "theta"), phis = column(fields, "phi");
  // The mount is said in the scanner's parameters, by the same names.
  const Params mount = make_params("georeference");
  const char *all = nullptr, *some = nullptr;
  must(jalon_params_to_json(scanner.get(), &all));
  must(jalon_params_to_json(mount.get(), &some));
  const DriveJson told = DriveJson::parse(all);
  DriveJson values = DriveJson::parse(some);
  for (const auto& [name, value] : values.items())
    if (told.contains(name)) values[name] = told[name];
  must(jalon_params_from_json(mount.get(), values.dump().c_str()));
  Cloud made;
  must(jalon_trajectory_georeference(trajectory.get(), times.data(), ranges.data(), thetas.data(),
                                     phis.data(), times.size(), mount.get(), task, Out(made)));
  return made;
}

// street.city.json -> street.true.city.json
std::string true_name(const std::string& path) {
  const std::filesystem::path whole(path);
  const std::string name = whole.filename().string();
  const size_t dot = name.find('.');
  const std::string end = dot == std::string::npos ? "" : name.substr(dot);
  return (whole.parent_path() / (name.substr(0, dot) + ".true" + end)).string();
}

Params scenario_options(const DriveScan& scan) {
  Params options = make_params("drive_scenario");
  must(jalon_params_set_bool(options.get(), "closed", 1));
  must(jalon_params_set_int64(options.get(), "scenario", scan.scenario));
  must(jalon_params_set_int64(options.get(), "seed", scan.drift_seed));
  must(jalon_params_set_double(options.get(), "noise_range_m", 0.005));
  scan.street.apply(options.get());
  return options;
}

// What a user has, and beside it what is true.
void write_scenario(const DriveScan& scan, Console& console) {
  if (scan.scanner.is_given())
    throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                  "a scenario has its scanner among the parameters of --scene-set: no --set"};
  if (scan.drift_seed == 0)
    throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                  "a scenario has errors: --drift-seed 0 is a drive without"};
  check_output_file(true_name(scan.trajectory_output));
  if (!scan.model_output.empty()) check_output_file(true_name(scan.model_output), "model");
  const Params options = scenario_options(scan);
  int64_t scenario = 0;
  must(jalon_params_get_int64(options.get(), "scenario", &scenario));
  console.step("scanning");
  Model model, true_model;
  Trajectory trajectory, true_trajectory;
  Cloud cloud;
  must(jalon_scene_drive_scenario(options.get(), console.task(), Out(model), Out(trajectory),
                                  Out(cloud), Out(true_model), Out(true_trajectory)));
  const double seconds = console.seconds();
  console.step("writing");
  const auto written = [&](const Trajectory& t, const std::string& path) {
    must(jalon_trajectory_write(t.get(), path.c_str(), nullptr, nullptr, console.task()));
  };
  must(jalon_cloud_write(cloud.get(), scan.output.c_str(), nullptr, console.task()));
  written(trajectory, scan.trajectory_output);
  written(true_trajectory, true_name(scan.trajectory_output));
  const auto kept = [&](const Model& m, const std::string& path) {
    must(jalon_model_write(m.get(), path.c_str(), nullptr, console.task()));
  };
  if (!scan.model_output.empty()) {
    kept(model, scan.model_output);
    kept(true_model, true_name(scan.model_output));
  }
  console.say(grouped(count_of(cloud)) + " points of a drive in " + fixed(seconds, 2) + " s -> " +
              scan.output + ", " + scan.trajectory_output + "; the truth -> " +
              true_name(scan.trajectory_output));
  console.result(DriveJson{{"scene", "drive_scenario"},
                           {"scenario", scenario},
                           {"output", scan.output},
                           {"trajectory", scan.trajectory_output},
                           {"points", count_of(cloud)},
                           {"seconds", seconds}});
}

}  // namespace

void scan_by_drive(const DriveScan& scan, const Common& common) {
  check_output_file(scan.trajectory_output);
  if (!scan.model_output.empty()) check_output_file(scan.model_output, "model");
  Console console(common);
  console.step("scene");
  if (scan.scenario >= 0) return write_scenario(scan, console);
  const Params options = street_options(scan.street);
  Params scanner_params;
  const Scanner scanner = mobile_scanner(scan.scanner, scanner_params);
  Model street;
  Trajectory truth, trajectory;
  must(jalon_scene_street_drive(options.get(), Out(street), Out(truth)));
  console.step("scanning");
  Cloud measured;
  must(
      jalon_scanner_drive(scanner.get(), street.get(), truth.get(), console.task(), Out(measured)));
  trajectory = scan.drift_seed == 0 ? std::move(truth) : with_drift(truth, scan.drift_seed);
  const Cloud cloud = points_of(measured, trajectory, scanner_params, console.task());
  const double seconds = console.seconds();
  console.step("writing");
  must(jalon_cloud_write(cloud.get(), scan.output.c_str(), nullptr, console.task()));
  must(jalon_trajectory_write(trajectory.get(), scan.trajectory_output.c_str(), nullptr, nullptr,
                              console.task()));
  if (!scan.model_output.empty())
    must(jalon_model_write(street.get(), scan.model_output.c_str(), nullptr, console.task()));
  console.say(grouped(count_of(cloud)) + " points of a drive in " + fixed(seconds, 2) + " s -> " +
              scan.output + ", " + scan.trajectory_output);
  console.result(DriveJson{{"scene", "street_drive"},
                           {"output", scan.output},
                           {"trajectory", scan.trajectory_output},
                           {"points", count_of(cloud)},
                           {"seconds", seconds}});
}

}  // namespace jalon::cli
