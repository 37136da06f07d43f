// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/report.h"

#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "capi/support/report_files.h"
#include "capi/support/worker_handles.h"
#include "report/pictures/ortho_files.h"
#include "report/pictures/picture.h"
#include "report/report.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

// A segmentation alone, without outlines, is reported too.
ModelPtr model_or_none(const jalon_segmentation* segmentation, const jalon_model* model) {
  require(segmentation, "segmentation");
  return model != nullptr ? model->model : std::make_shared<const Model>();
}

}  // namespace

jalon_status jalon_report_write_elevation(const jalon_segmentation* segmentation,
                                          const jalon_model* model, const char* path,
                                          const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(model, "model");
    const std::string target = require_text(path, "path");
    const auto settings =
        settings_from<ElevationSettings>(options_or_default(options, "elevation"));
    with_task(task, [&](Task& t) {
      write_whole(target, elevation_svg(*segmentation->segmentation, *model->model, settings, t));
    });
  });
}

jalon_status jalon_report_write_picture(const jalon_segmentation* segmentation, const char* path,
                                        const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(segmentation, "segmentation");
    const std::string target = require_text(path, "path");
    const auto settings = settings_from<PictureSettings>(options_or_default(options, "picture"));
    with_task(task, [&](Task& t) {
      const Segmentation& s = *segmentation->segmentation;
      write_whole(target,
                  is_png(target) ? picture_png(s, settings, t) : picture_svg(s, settings, t));
    });
  });
}

jalon_status jalon_report_write_orthoimage(const jalon_segmentation* segmentation,
                                           const jalon_model* model, const char* path,
                                           const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(model, "model");
    const std::string target = require_text(path, "path");
    const auto settings =
        settings_from<OrthoimageSettings>(options_or_default(options, "orthoimage"));
    with_task(task, [&](Task& t) {
      write_orthoimage(*segmentation->segmentation->cloud, *model->model, settings, target, t);
    });
  });
}

jalon_status jalon_report_write_html(const jalon_segmentation* segmentation,
                                     const jalon_model* model, const char* notes_json,
                                     const char* path, const jalon_params* options,
                                     jalon_task* task) {
  return guard([&] {
    const ModelPtr outlines = model_or_none(segmentation, model);
    const std::string target = require_text(path, "path"), notes = notes_text(notes_json);
    const auto settings = settings_from<ReportSettings>(options_or_default(options, "report"));
    with_task(task, [&](Task& t) {
      write_whole(target, report_html(*segmentation->segmentation, *outlines, notes, settings, t));
    });
  });
}

jalon_status jalon_report_write_json(const jalon_segmentation* segmentation,
                                     const jalon_model* model, const char* notes_json,
                                     const char* path, const jalon_params* options,
                                     jalon_task* task) {
  return guard([&] {
    const ModelPtr outlines = model_or_none(segmentation, model);
    const std::string target = require_text(path, "path"), notes = notes_text(notes_json);
    options_or_default(options, "report");  // refuses a foreign set
    with_task(task, [&](Task& t) {
      write_whole(target, report_json(*segmentation->segmentation, *outlines, notes, t));
    });
  });
}
