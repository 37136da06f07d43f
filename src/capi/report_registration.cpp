// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/guard.h"
#include "capi/support/registration_handles.h"
#include "capi/support/report_files.h"
#include "jalon/report.h"
#include "report/pages/registration_report.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_report_write_registration(const jalon_registration* registration,
                                             const jalon_cloud* reference,
                                             const jalon_cloud* moving, const char* notes_json,
                                             const char* path, const jalon_params* options,
                                             jalon_task* task) {
  return guard([&] {
    require(registration, "registration");
    const std::string target = require_text(path, "path"), notes = notes_text(notes_json);
    const auto settings = settings_from<RegistrationReportSettings>(
        options_or_default(options, "registration_report"));
    const CloudPtr to = reference != nullptr ? reference->cloud : nullptr;
    const CloudPtr from = moving != nullptr ? moving->cloud : nullptr;
    with_task(task, [&](Task& t) {
      write_whole(target,
                  registration_html(*registration->registration, to, from, notes, settings, t));
    });
  });
}
