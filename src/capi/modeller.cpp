// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/modeller.h"

#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "capi/support/worker_handles.h"
#include "modelling/facade/facade.h"
#include "modelling/outlines.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

struct Method {
  const char* name;
  const char* owner;  ///< of its parameters
  std::span<const ParamRow> (*rows)();
  Model (*run)(const Segmentation&, const ParamSet&, Task&);
};
constexpr Method kMethods[] = {{"outlines", "modeller outlines", outlines_rows, model_outlines},
                               {"facade", "modeller facade", facade_rows, model_facade},
                               {"extrusion", "modeller extrusion", extrusion_rows, model_extrusion}};

const Method& method_of(const std::string& name) {
  for (const Method& method : kMethods)
    if (name == method.name) return method;
  fail(Status::kNotFound, "no modelling method \"%.100s\"; there are: outlines, facade, extrusion", name.c_str());
}

}  // namespace

jalon_status jalon_modeller_create(const char* method, jalon_modeller** out) {
  return guard([&] {
    require(out, "out");
    const std::string name = method != nullptr ? require_text(method, "method") : "outlines";
    const Method& found = method_of(name);
    auto handle = std::make_unique<jalon_modeller>();
    handle->method = name;
    handle->values = std::make_shared<ParamSet>(found.owner, found.rows());
    *out = handle.release();
  });
}

jalon_modeller* jalon_modeller_retain(jalon_modeller* modeller) { return retain(modeller); }
void jalon_modeller_release(jalon_modeller* modeller) { release(modeller); }

jalon_status jalon_modeller_params(jalon_modeller* modeller, jalon_params** out) {
  return give_params(modeller, "modeller", out);
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
    const Method& method = method_of(modeller->method);
    *out = with_task(task, [&](Task& t) {
             return own(new_model(method.run(*segmentation->segmentation, values, t)));
           }).release();
  });
}
