// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/segmenter.h"

#include "capi/guard.h"
#include "capi/worker_handles.h"
#include "segment/tables.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

struct Method {
  const char* name;
  const char* owner;  ///< of its parameters
  std::span<const ParamRow> (*rows)();
  Segmentation (*run)(const CloudPtr&, const ParamSet&, Task&);
};
constexpr Method kMethods[] = {{"ransac", "segmenter ransac", ransac_rows, segment_ransac},
                               {"region_growing", "segmenter region_growing", region_growing_rows,
                                segment_region_growing}};

const Method& method_of(const std::string& name) {
  for (const Method& method : kMethods)
    if (name == method.name) return method;
  fail(Status::kNotFound, "no segmentation method \"%.100s\"; there are: ransac, region_growing", name.c_str());
}

}  // namespace

jalon_status jalon_segmenter_create(const char* method, jalon_segmenter** out) {
  return guard([&] {
    require(out, "out");
    const std::string name = method != nullptr ? require_text(method, "method") : "ransac";
    const Method& found = method_of(name);
    auto handle = std::make_unique<jalon_segmenter>();
    handle->method = name;
    handle->values = std::make_shared<ParamSet>(found.owner, found.rows());
    *out = handle.release();
  });
}

jalon_segmenter* jalon_segmenter_retain(jalon_segmenter* segmenter) { return retain(segmenter); }
void jalon_segmenter_release(jalon_segmenter* segmenter) { release(segmenter); }

jalon_status jalon_segmenter_params(jalon_segmenter* segmenter, jalon_params** out) {
  return guard([&] {
    require(segmenter, "segmenter");
    require(out, "out");
    auto handle = std::make_unique<jalon_params>();
    handle->operation = "segmenter " + segmenter->method;
    handle->values = segmenter->values;
    *out = handle.release();
  });
}

jalon_status jalon_segmenter_run(const jalon_segmenter* segmenter, const jalon_cloud* cloud, jalon_task* task,
                                 jalon_segmentation** out) {
  return guard([&] {
    require(segmenter, "segmenter");
    require(cloud, "cloud");
    require(out, "out");
    const ParamSet values = *segmenter->values;  // a progress callback may set the next run's
    auto handle = std::make_unique<jalon_segmentation>();
    with_task(task, [&](Task& t) {
      handle->segmentation =
          std::make_shared<const Segmentation>(method_of(segmenter->method).run(cloud->cloud, values, t));
    });
    *out = handle.release();
  });
}

jalon_segmentation* jalon_segmentation_retain(jalon_segmentation* segmentation) { return retain(segmentation); }
void jalon_segmentation_release(jalon_segmentation* segmentation) { release(segmentation); }

jalon_status jalon_segmentation_points(const jalon_segmentation* segmentation, jalon_fields** out) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out, "out");
    *out = new_fields(point_table(*segmentation->segmentation));
  });
}

jalon_status jalon_segmentation_segments(const jalon_segmentation* segmentation, jalon_fields** out) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out, "out");
    *out = new_fields(segment_table(*segmentation->segmentation));
  });
}

jalon_status jalon_segmentation_cloud(const jalon_segmentation* segmentation, jalon_cloud** out) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out, "out");
    Cloud cloud = *segmentation->segmentation->cloud;
    for (const ColumnPtr& column : point_table(*segmentation->segmentation)) cloud.fields.set(column);
    *out = new_cloud(std::move(cloud));
  });
}

jalon_status jalon_segmentation_facade_frame(const jalon_segmentation* segmentation, jalon_transform* T_facade_world) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(T_facade_world, "T_facade_world");
    *T_facade_world = to_c(segmentation->segmentation->T_facade_world);
  });
}
