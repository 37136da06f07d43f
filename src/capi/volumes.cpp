// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/volumes.h"

#include "capi/support/comparison_handles.h"
#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "compare/distance/model_sample.h"
#include "compare/volumes/volume.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

void hand_out(const Volume& volume, jalon_fields** out_summary, jalon_fields** out_cells) {
  auto summary = own(new_fields(volume.summary)), cells = own(new_fields(volume.cells));
  if (out_summary != nullptr) *out_summary = summary.release();
  if (out_cells != nullptr) *out_cells = cells.release();
}

}  // namespace

jalon_status jalon_cloud_volume(const jalon_cloud* reference, const jalon_cloud* compared,
                                const jalon_params* options, jalon_task* task,
                                jalon_fields** out_summary, jalon_fields** out_cells) {
  return guard([&] {
    require(reference, "reference");
    require(compared, "compared");
    require_same_crs(reference->cloud->crs, compared->cloud->crs);
    const auto settings = settings_from<VolumeSettings>(options_or_default(options, "volume"));
    const CloudPtr before = reference->cloud, after = compared->cloud;
    hand_out(with_task(task, [&](Task& t) { return volume_between(*before, *after, settings, t); }),
             out_summary, out_cells);
  });
}

jalon_status jalon_model_volume(const jalon_model* reference, const jalon_model* compared,
                                const jalon_params* options, jalon_task* task,
                                jalon_fields** out_summary, jalon_fields** out_cells) {
  return guard([&] {
    require(reference, "reference");
    require(compared, "compared");
    require_same_crs(reference->model->crs, compared->model->crs);
    const auto settings = settings_from<VolumeSettings>(options_or_default(options, "volume"));
    const ModelPtr before = reference->model, after = compared->model;
    hand_out(with_task(task, [&](Task& t) { return volume_between(*before, *after, settings, t); }),
             out_summary, out_cells);
  });
}

jalon_status jalon_model_sample(const jalon_model* model, const jalon_params* options,
                                jalon_task* task, jalon_cloud** out) {
  return guard([&] {
    require(model, "model");
    require(out, "out");
    const auto settings =
        settings_from<ModelSampleSettings>(options_or_default(options, "model_sample"));
    const ModelPtr surfaces = model->model;
    *out = with_task(task, [&](Task& t) {
             return own(new_cloud(sample_model(*surfaces, settings, t)));
           }).release();
  });
}
