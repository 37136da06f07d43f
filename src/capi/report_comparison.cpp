// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/cloud_handle.h"
#include "capi/support/comparison_handles.h"
#include "capi/support/gauge_pieces.h"
#include "capi/support/guard.h"
#include "capi/support/report_files.h"
#include "jalon/report.h"
#include "report/pages/clearance_report.h"
#include "report/pages/comparison_report.h"
#include "report/pictures/deviation_picture.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_report_write_deviations(const jalon_comparison* comparison, const char* path,
                                           const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(comparison, "comparison");
    const std::string target = require_text(path, "path");
    const auto settings =
        settings_from<DeviationPictureSettings>(options_or_default(options, "deviation_picture"));
    with_task(task, [&](Task& t) {
      const Comparison* one[] = {comparison->comparison.get()};
      const DeviationScale scale = deviation_scale(one, settings.limit_m);
      const auto draw = is_png(target) ? deviation_png : deviation_svg;
      write_whole(target, draw(*one[0], scale, settings, t));
    });
  });
}

jalon_status jalon_report_write_histogram(const jalon_comparison* comparison, const char* path,
                                          const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(comparison, "comparison");
    const std::string target = require_text(path, "path");
    const auto settings =
        settings_from<ComparisonReportSettings>(options_or_default(options, "comparison_report"));
    with_task(task, [&](Task& t) {
      write_whole(target, comparison_histogram(*comparison->comparison, settings, t));
    });
  });
}

jalon_status jalon_report_write_comparison(const jalon_comparison* forward,
                                           const jalon_comparison* reverse,
                                           const jalon_fields* changes, const char* notes_json,
                                           const char* path, const jalon_params* options,
                                           jalon_task* task) {
  return guard([&] {
    require(forward, "forward");
    const std::string target = require_text(path, "path"), notes = notes_text(notes_json);
    const auto settings =
        settings_from<ComparisonReportSettings>(options_or_default(options, "comparison_report"));
    const Comparison* other = reverse != nullptr ? reverse->comparison.get() : nullptr;
    const FieldTable table = changes != nullptr ? changes->table : FieldTable();
    with_task(task, [&](Task& t) {
      write_whole(target, comparison_html(*forward->comparison, other, table, notes, settings, t));
    });
  });
}

jalon_status jalon_report_write_clearance(const jalon_fields* places, const jalon_fields* intervals,
                                          const jalon_gauge_piece* pieces, uint64_t piece_count,
                                          const double* hull_points, uint64_t hull_point_count,
                                          const jalon_model* gauge, const jalon_transform* poses,
                                          uint64_t pose_count, const jalon_cloud* cloud,
                                          const jalon_model* model, const char* notes_json,
                                          const char* path, const jalon_params* options,
                                          jalon_task* task) {
  return guard([&] {
    require(places, "places");
    require(intervals, "intervals");
    const std::string target = require_text(path, "path"), notes = notes_text(notes_json);
    const auto settings =
        settings_from<ClearanceReportSettings>(options_or_default(options, "clearance_report"));
    GaugeRun run{places->table,
                 intervals->table,
                 {},
                 pose_list(poses, pose_count),
                 cloud != nullptr ? cloud->cloud : nullptr,
                 model != nullptr ? model->model : nullptr};
    for (const Transform& pose : run.poses) require_rigid(pose, "a pose");
    if (piece_count > 0)
      run.gauge = gauge_outlines(pieces, piece_count, hull_points, hull_point_count);
    if (gauge != nullptr)
      for (std::vector<Vec3>& corners : gauge_corners(*gauge->model, kDrawnChord_m))
        run.gauge.push_back(std::move(corners));
    with_task(task, [&](Task& t) { write_whole(target, clearance_html(run, notes, settings, t)); });
  });
}
