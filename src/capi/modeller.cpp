// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/modeller.h"

#include <cstring>

#include "capi/support/guard.h"
#include "capi/support/methods.h"
#include "capi/support/model_handles.h"
#include "capi/support/worker_handles.h"
#include "modelling/edge_curve.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

// Clouds share their points, whatever fields were added since; a segmentation that came from bytes has its own.
bool has_same_points(const Cloud& a, const Cloud& b) {
  if (a.xyz_buffer == b.xyz_buffer || a.size() + b.size() == 0) return true;
  return a.size() == b.size() &&
         std::memcmp(a.xyz_buffer->data(), b.xyz_buffer->data(), a.xyz().size_bytes()) == 0;
}

}  // namespace

jalon_status jalon_modeller_create(const char* method, jalon_modeller** out) {
  return create_worker(modelling_methods(), method, "modelling method", out);
}

jalon_status jalon_modeller_methods(const char* const** names, uint64_t* count) {
  return guard([&] { give_names(modelling_method_names(), names, count); });
}

jalon_status jalon_modeller_copy(const jalon_modeller* modeller, jalon_modeller** out) {
  return copy_worker(modeller, "modeller", out);
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
    if (!has_same_points(*cloud->cloud, *segmentation->segmentation->cloud))
      fail(Status::kInvalidArgument, "the segmentation is of another cloud");
    *out = run_worker(*modeller, task, [&](const ParamSet& values, Task& t) {
             return own(new_model(modeller->method->run(*segmentation->segmentation, values, t)));
           }).release();
  });
}

jalon_status jalon_segmentation_long_edges(const jalon_segmentation* segmentation, uint32_t label,
                                           const jalon_params* options, jalon_task* task,
                                           jalon_fields** out_lengths, jalon_fields** out_points,
                                           jalon_fields** out_summary) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out_lengths, "out_lengths");
    require(out_points, "out_points");
    const auto chosen = settings_from<EdgeCurveSettings>(options_or_default(options, "long_edges"));
    const EdgeCurve curve = with_task(task, [&](Task& t) {
      return find_edge_curve(*segmentation->segmentation, label, chosen, t);
    });
    auto lengths = own(new_fields(edge_length_table(curve)));
    auto points = own(new_fields(contour_point_table(curve)));
    if (out_summary != nullptr) *out_summary = new_fields(edge_summary_table(curve));
    *out_lengths = lengths.release();
    *out_points = points.release();
  });
}
