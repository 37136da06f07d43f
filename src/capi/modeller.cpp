// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/modeller.h"

#include "capi/support/guard.h"
#include "capi/support/methods.h"
#include "capi/support/model_handles.h"
#include "capi/support/worker_handles.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_modeller_create(const char* method, jalon_modeller** out) {
  return create_worker(modelling_methods(), method, "modelling method", out);
}

jalon_status jalon_modeller_methods(const char* const** names, uint64_t* count) {
  return guard([&] { give_names(modelling_method_names(), names, count); });
}

jalon_modeller* jalon_modeller_retain(jalon_modeller* modeller) { return retain(modeller); }
void jalon_modeller_release(jalon_modeller* modeller) { release(modeller); }

jalon_status jalon_modeller_params(jalon_modeller* modeller, jalon_params** out) {
  return give_worker_params(modeller, "modeller", out);
}

jalon_status jalon_modeller_run(const jalon_modeller* modeller, const jalon_cloud* cloud,
                                const jalon_segmentation* segmentation, jalon_task* task,
                                jalon_model** out) {
  return guard([&] {
    require(modeller, "modeller");
    require(cloud, "cloud");
    require(segmentation, "segmentation");
    require(out, "out");
    // Points are shared, never copied: the same buffer is the same cloud, whatever fields were added since.
    if (cloud->cloud->xyz_buffer != segmentation->segmentation->cloud->xyz_buffer)
      fail(Status::kInvalidArgument, "the segmentation is of another cloud");
    *out = run_worker(*modeller, task, [&](const ParamSet& values, Task& t) {
             return own(new_model(modeller->method->run(*segmentation->segmentation, values, t)));
           }).release();
  });
}
