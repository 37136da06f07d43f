// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/adjustment_handles.h"
#include "capi/support/guard.h"
#include "capi/support/network_handles.h"
#include "capi/support/report_files.h"
#include "capi/support/trajectory_handles.h"
#include "jalon/report.h"
#include "report/names/notes.h"
#include "report/pages/adjustment_report.h"
#include "report/pages/network_report.h"
#include "report/pictures/network_plan.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_report_write_adjustment(const jalon_adjustment* adjustment,
                                           const jalon_trajectory* truth, const char* notes_json,
                                           const char* path, const jalon_params* options,
                                           jalon_task* task) {
  return guard([&] {
    require(adjustment, "adjustment");
    const std::string target = require_text(path, "path"), notes = notes_text(notes_json);
    const auto settings =
        settings_from<AdjustmentReportSettings>(options_or_default(options, "adjustment_report"));
    const AdjustedInputs inputs{*adjustment->model, *adjustment->trajectory,
                                truth != nullptr ? truth->trajectory.get() : nullptr};
    with_task(task, [&](Task& t) {
      write_whole(target, adjustment_html(*adjustment->adjustment, inputs, notes, settings, t));
    });
  });
}

jalon_status jalon_report_write_network(const jalon_network* network, const char* notes_json,
                                        const char* path, jalon_task* task) {
  return guard([&] {
    require(network, "network");
    const std::string target = require_text(path, "path"), notes = notes_text(notes_json);
    with_task(task, [&](Task& t) {
      write_whole(target, target.ends_with(".svg")
                              ? network_plan_svg(network->network,
                                                 notes.empty() ? "" : read_notes(notes).title, t)
                              : network_html(network->network, network->parameters, notes, t));
    });
  });
}
