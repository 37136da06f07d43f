// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/modeller.h"

#include "capi/guard.h"
#include "capi/model_handles.h"
#include "capi/worker_handles.h"
#include "modelling/outlines.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_modeller_create(const char* method, jalon_modeller** out) {
  return guard([&] {
    require(out, "out");
    const std::string name = method != nullptr ? require_text(method, "method") : "outlines";
    if (name != "outlines") fail(Status::kNotFound, "no modelling method \"%.100s\"; there is: outlines", name.c_str());
    auto handle = std::make_unique<jalon_modeller>();
    handle->values = std::make_shared<ParamSet>("modeller outlines", outlines_rows());
    *out = handle.release();
  });
}

jalon_modeller* jalon_modeller_retain(jalon_modeller* modeller) { return retain(modeller); }
void jalon_modeller_release(jalon_modeller* modeller) { release(modeller); }

jalon_status jalon_modeller_params(jalon_modeller* modeller, jalon_params** out) {
  return guard([&] {
    require(modeller, "modeller");
    require(out, "out");
    auto handle = std::make_unique<jalon_params>();
    handle->operation = "modeller outlines";
    handle->values = modeller->values;
    *out = handle.release();
  });
}

jalon_status jalon_modeller_run(const jalon_modeller* modeller, const jalon_cloud* cloud,
                                const jalon_segmentation* segmentation, jalon_task* task, jalon_model** out) {
  return guard([&] {
    require(modeller, "modeller");
    require(cloud, "cloud");
    require(segmentation, "segmentation");
    require(out, "out");
    // Points are shared, never copied: the same buffer is the same cloud, whatever fields were added since.
    if (cloud->cloud->xyz_buffer != segmentation->segmentation->cloud->xyz_buffer)
      fail(Status::kInvalidArgument, "the segmentation is of another cloud");
    const ParamSet values = *modeller->values;  // a progress callback may set the next run's
    *out = with_task(task, [&](Task& t) {
             return own(new_model(model_outlines(*segmentation->segmentation, values, t)));
           }).release();
  });
}
