// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/settings_json.h"
#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "capi/support/report_files.h"
#include "capi/support/scan_handles.h"
#include "capi/support/trajectory_handles.h"
#include "jalon/scanner.h"
#include "scan/facade_truth.h"
#include "scan/methods.h"
#include "scan/mobile/drive_scenario.h"
#include "scan/mobile/street_drive.h"
#include "scan/scene.h"
#include "scan/yard/yard.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

SceneSettings scene_settings(const jalon_params* options) {
  return settings_from<SceneSettings>(options_or_default(options, "scene"));
}

/// What the scanner would do; without stations the scene's own ones.
SceneSurvey survey_of(const jalon_scanner& scanner) {
  if (scanner.method->rows != static_scanner_rows)
    fail(Status::kUnsupported,
         "method \"%s\" has no stations that could see anything; use \"static\"",
         scanner.method->name);
  return {scanner.stations, resolved(settings_from<StaticSettings>(*scanner.values))};
}

}  // namespace

jalon_status jalon_scene_create(const jalon_params* options, jalon_task* task, jalon_model** out) {
  return guard([&] {
    require(out, "out");
    const SceneSettings settings = scene_settings(options);
    *out = with_task(task, [&](Task& t) {
             return own(new_model(build_scene(settings, t)));
           }).release();
  });
}

jalon_status jalon_scene_scanner(const jalon_params* options, jalon_scanner** out) {
  return guard([&] {
    require(out, "out");
    SceneSurvey survey = scene_survey(scene_settings(options));
    auto handle = std::make_unique<jalon_scanner>();
    handle->method = &find_method(scanner_methods(), "static", "scanner");
    handle->values = std::make_shared<ParamSet>(handle->method->owner, handle->method->rows());
    handle->values->from_json(settings_json(static_scanner_rows(), survey.scanner));
    handle->stations = std::move(survey.stations);
    *out = handle.release();
  });
}

jalon_status jalon_scene_write_truth(const char* path, const jalon_scanner* scanner,
                                     const jalon_params* options, jalon_task* task) {
  return guard([&] {
    const SceneSettings settings =
        options == nullptr ? SceneSettings{.name = SceneName::kGrammar} : scene_settings(options);
    const SceneSurvey survey = scanner == nullptr ? SceneSurvey{} : survey_of(*scanner);
    const std::string target = require_text(path, "path");
    with_task(task, [&](Task& t) {
      write_whole(target, settings.name == SceneName::kYard
                              ? json_of(yard_truth(settings), settings)
                              : json_of(facade_truth(settings, survey, t)));
    });
  });
}

jalon_status jalon_scene_street_drive(const jalon_params* options, jalon_model** model,
                                      jalon_trajectory** trajectory) {
  return guard([&] {
    StreetDrive made = street_drive(
        settings_from<StreetDriveSettings>(options_or_default(options, "street_drive")));
    Owned<jalon_model> street = own(new_model(std::move(made.model)));
    Owned<jalon_trajectory> drive = own(new_trajectory(std::move(made.trajectory)));
    if (model != nullptr) *model = street.release();
    if (trajectory != nullptr) *trajectory = drive.release();
  });
}

jalon_status jalon_scene_drive_scenario(const jalon_params* options, jalon_task* task,
                                        jalon_model** model, jalon_trajectory** trajectory,
                                        jalon_cloud** cloud, jalon_model** true_model,
                                        jalon_trajectory** true_trajectory) {
  return guard([&] {
    const auto settings =
        settings_from<DriveScenarioSettings>(options_or_default(options, "drive_scenario"));
    Owned<jalon_model> given = own<jalon_model>(nullptr), truth = own<jalon_model>(nullptr);
    Owned<jalon_trajectory> drive = own<jalon_trajectory>(nullptr),
                            true_drive = own<jalon_trajectory>(nullptr);
    Owned<jalon_cloud> points = own<jalon_cloud>(nullptr);
    with_task(task, [&](Task& t) {
      DriveScenario made = drive_scenario(settings, t);
      given.reset(new_model(std::move(made.model)));
      truth.reset(new_model(std::move(made.true_model)));
      drive.reset(new_trajectory(std::move(made.trajectory)));
      true_drive.reset(new_trajectory(std::move(made.true_trajectory)));
      points.reset(new_cloud(std::move(made.cloud)));
    });
    if (model != nullptr) *model = given.release();
    if (trajectory != nullptr) *trajectory = drive.release();
    if (cloud != nullptr) *cloud = points.release();
    if (true_model != nullptr) *true_model = truth.release();
    if (true_trajectory != nullptr) *true_trajectory = true_drive.release();
  });
}
