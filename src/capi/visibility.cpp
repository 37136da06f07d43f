// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/visibility.h"

#include "capi/support/comparison_handles.h"
#include "capi/support/guard.h"
#include "compare/visibility/depth_table.h"
#include "compare/visibility/recovery.h"
#include "compare/visibility/visibility.h"
#include "formats/files/atomic_file.h"
#include "report/pictures/depth_picture.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

DepthSettings settings_of_of_visibility(const jalon_params* options) {
  return settings_from<DepthSettings>(options_or_default(options, "visibility"));
}

}  // namespace

jalon_status jalon_cloud_compute_visibility(jalon_cloud* cloud, const jalon_cloud* reference,
                                            const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    require(reference, "reference");
    const DepthSettings settings = settings_of_of_visibility(options);
    auto changed = with_task(task, [&](Task& t) {
      return std::make_shared<const Cloud>(
          with_visibility(*reference->cloud, *cloud->cloud, settings, t));
    });
    cloud->cloud = std::move(changed);
  });
}

jalon_status jalon_cloud_depth_map(const jalon_cloud* reference, uint64_t station,
                                   const jalon_params* options, jalon_task* task,
                                   jalon_fields** out, uint64_t* rows, uint64_t* columns) {
  return guard([&] {
    require(reference, "reference");
    require(out, "out");
    const DepthSettings settings = settings_of_of_visibility(options);
    AngularGrid grid;
    *out = with_task(task, [&](Task& t) {
             const DepthMap map = station_depth_map(*reference->cloud, station, settings, t);
             grid = map.grid();
             return own(new_fields(depth_table(map, t)));
           }).release();
    if (rows != nullptr) *rows = grid.rows;
    if (columns != nullptr) *columns = grid.columns;
  });
}

jalon_status jalon_cloud_write_depth_map(const jalon_cloud* reference, uint64_t station,
                                         const char* path, const jalon_params* options,
                                         jalon_task* task) {
  return guard([&] {
    require(reference, "reference");
    const std::string target = require_text(path, "path");
    const DepthSettings settings = settings_of_of_visibility(options);
    with_task(task, [&](Task& t) {
      const bool is_tiff = target.ends_with(".tif") || target.ends_with(".tiff");
      AtomicFile file(target);
      const DepthMap map = station_depth_map(*reference->cloud, station, settings, t);
      file.write(is_tiff ? depth_tiff(map, t) : depth_png(map, t));
      file.commit();
    });
  });
}

jalon_status jalon_comparison_third_epoch(const jalon_comparison* hidden,
                                          const jalon_comparison* across, double tolerance_m,
                                          jalon_task* task, jalon_comparison** out) {
  return guard([&] {
    require(hidden, "hidden");
    require(across, "across");
    require(out, "out");
    *out = with_task(task, [&](Task& t) {
             auto handle = std::make_unique<jalon_comparison>();
             handle->comparison = std::make_shared<const Comparison>(
                 with_third_epoch(*hidden->comparison, *across->comparison, tolerance_m, t));
             return handle;
           }).release();
  });
}
