// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/scanner.h"

#include "capi/support/guard.h"
#include "capi/support/methods.h"
#include "capi/support/model_handles.h"
#include "capi/support/scan_handles.h"
#include "capi/support/trajectory_handles.h"
#include "scan/methods.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_scanner_create(const char* method, jalon_scanner** out) {
  return create_worker(scanner_methods(), method, "scanner", out);
}

jalon_status jalon_scanner_methods(const char* const** names, uint64_t* count) {
  return guard([&] { give_names(scanner_method_names(), names, count); });
}

jalon_status jalon_scanner_copy(const jalon_scanner* scanner, jalon_scanner** out) {
  return guard([&] {
    require(scanner, "scanner");
    require(out, "out");
    auto handle = copy_of(*scanner);
    handle->stations = scanner->stations;
    *out = handle.release();
  });
}

jalon_scanner* jalon_scanner_retain(jalon_scanner* scanner) { return retain(scanner); }
void jalon_scanner_release(jalon_scanner* scanner) { release(scanner); }

jalon_status jalon_scanner_params(jalon_scanner* scanner, jalon_params** out) {
  return give_worker_params(scanner, "scanner", out);
}

jalon_status jalon_scanner_add_station(jalon_scanner* scanner, const char* name,
                                       const jalon_transform* pose) {
  return guard([&] {
    require(scanner, "scanner");
    require(pose, "pose");
    ScanStation station;
    if (name != nullptr) station.name = require_text(name, "name");
    station.pose = require_pose(*pose);
    scanner->stations.push_back(std::move(station));
  });
}

jalon_status jalon_scanner_run(const jalon_scanner* scanner, const jalon_model* model,
                               jalon_task* task, jalon_cloud** out) {
  return guard([&] {
    require(scanner, "scanner");
    require(model, "model");
    require(out, "out");
    const ParamSet values =
        *scanner->values;  // a progress callback may set the next run's, and add stations
    const std::vector<ScanStation> stations = scanner->stations;
    const auto run = require_run(scanner_methods(), *scanner->method, &ScannerMethod::scan,
                                 "drives along a trajectory and has no stations");
    *out = with_task(task, [&](Task& t) {
             return own(new_cloud(run(*model->model, stations, values, t)));
           }).release();
  });
}

jalon_status jalon_scanner_drive(const jalon_scanner* scanner, const jalon_model* model,
                                 const jalon_trajectory* trajectory, jalon_task* task,
                                 jalon_cloud** out) {
  return guard([&] {
    require(scanner, "scanner");
    require(model, "model");
    require(trajectory, "trajectory");
    require(out, "out");
    const auto drive = require_run(scanner_methods(), *scanner->method, &ScannerMethod::drive,
                                   "does not drive along a trajectory");
    *out = run_worker(*scanner, task, [&](const ParamSet& values, Task& t) {
             return own(new_cloud(drive(*model->model, *trajectory->trajectory, values, t)));
           }).release();
  });
}

jalon_status jalon_scanner_truth(const jalon_scanner* scanner, const jalon_model* model,
                                 const jalon_cloud* cloud, jalon_task* task, jalon_fields** out) {
  return guard([&] {
    require(scanner, "scanner");
    require(model, "model");
    require(out, "out");
    const ParamSet values = *scanner->values;
    const std::shared_ptr<const Cloud> points = cloud == nullptr ? nullptr : cloud->cloud;
    const auto truth = require_run(scanner_methods(), *scanner->method, &ScannerMethod::truth,
                                   "numbers no planes");
    *out = with_task(task, [&](Task& t) {
             return own(new_fields(truth(*model->model, points.get(), values, t)));
           }).release();
  });
}
