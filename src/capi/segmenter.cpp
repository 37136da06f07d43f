// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/segmenter.h"

#include "capi/support/guard.h"
#include "capi/support/methods.h"
#include "capi/support/worker_handles.h"
#include "segment/result/residuals.h"
#include "segment/result/tables.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_segmenter_create(const char* method, jalon_segmenter** out) {
  return create_worker(segment_methods(), method, "segmentation method", out);
}

jalon_status jalon_segmenter_methods(const char* const** names, uint64_t* count) {
  return guard([&] { give_names(segment_method_names(), names, count); });
}

jalon_status jalon_segmenter_copy(const jalon_segmenter* segmenter, jalon_segmenter** out) {
  return copy_worker(segmenter, "segmenter", out);
}

jalon_segmenter* jalon_segmenter_retain(jalon_segmenter* segmenter) { return retain(segmenter); }
void jalon_segmenter_release(jalon_segmenter* segmenter) { release(segmenter); }

jalon_status jalon_segmenter_params(jalon_segmenter* segmenter, jalon_params** out) {
  return give_worker_params(segmenter, "segmenter", out);
}

jalon_status jalon_segmenter_run(const jalon_segmenter* segmenter, const jalon_cloud* cloud,
                                 jalon_task* task, jalon_segmentation** out) {
  return guard([&] {
    require(segmenter, "segmenter");
    require(cloud, "cloud");
    require(out, "out");
    const auto run = segmenter->method->run;
    *out = run_worker(*segmenter, task, [&](const ParamSet& values, Task& t) {
             auto handle = std::make_unique<jalon_segmentation>();
             handle->segmentation =
                 std::make_shared<const Segmentation>(run(cloud->cloud, values, t));
             return handle;
           }).release();
  });
}

jalon_segmentation* jalon_segmentation_retain(jalon_segmentation* segmentation) {
  return retain(segmentation);
}
void jalon_segmentation_release(jalon_segmentation* segmentation) { release(segmentation); }

jalon_status jalon_segmentation_points(const jalon_segmentation* segmentation, jalon_fields** out) {
  return give_fields(segmentation, "segmentation", out,
                     [&] { return point_table(*segmentation->segmentation); });
}

jalon_status jalon_segmentation_segments(const jalon_segmentation* segmentation,
                                         jalon_fields** out) {
  return give_fields(segmentation, "segmentation", out,
                     [&] { return segment_table(*segmentation->segmentation); });
}

jalon_status jalon_segmentation_cloud(const jalon_segmentation* segmentation, jalon_cloud** out) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out, "out");
    Cloud cloud = *segmentation->segmentation->cloud;
    for (const ColumnPtr& column : point_table(*segmentation->segmentation))
      cloud.fields.set(column);
    *out = new_cloud(std::move(cloud));
  });
}

jalon_status jalon_segmentation_facade_frame(const jalon_segmentation* segmentation,
                                             jalon_transform* T_facade_world) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(T_facade_world, "T_facade_world");
    *T_facade_world = to_c(segmentation->segmentation->T_facade_world);
  });
}

jalon_status jalon_segmentation_parameters(const jalon_segmentation* segmentation,
                                           const char** out) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out, "out");
    *out = segmentation->segmentation->parameters_json.c_str();
  });
}

jalon_status jalon_segmentation_notes(const jalon_segmentation* segmentation, const char** out) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out, "out");
    *out = segmentation->segmentation->notes_json.c_str();
  });
}

jalon_status jalon_segmentation_residuals(const jalon_segmentation* segmentation, uint32_t label,
                                          uint32_t bins, jalon_task* task, jalon_fields** out_bins,
                                          jalon_fields** out_normal) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out_bins, "out_bins");
    require(out_normal, "out_normal");
    constexpr uint32_t kMostBins = 10000;
    if (bins < 1 || bins > kMostBins)
      fail(Status::kInvalidArgument, "bins is %u; 1 ... %u are possible", bins, kMostBins);
    const Segmentation& s = *segmentation->segmentation;
    if (label > s.segments.size())
      fail(Status::kNotFound, "no segment with label %u; there are %zu segments", label,
           s.segments.size());
    auto [made_bins, made_normal] = with_task(task, [&](Task& t) {
      const Residuals residuals = bin_residuals(s, label, bins, t);
      return std::pair(own(new_fields(residual_bins_table(residuals))),
                       own(new_fields(residual_normal_table(residuals))));
    });
    *out_bins = made_bins.release();
    *out_normal = made_normal.release();
  });
}
