// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/adjustment.h"

#include "capi/support/adjustment_handles.h"
#include "capi/support/comparison_handles.h"
#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "capi/support/trajectory_handles.h"
#include "model/buildings/building_offsets.h"
#include "registration/joint/adjusted.h"
#include "registration/joint/adjusted_attributes.h"
#include "registration/joint/adjustment_tables.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

// What a getter of a table does.
void give_table(const jalon_adjustment* adjustment, jalon_fields** out,
                FieldTable (*table)(const JointAdjustment&)) {
  require(adjustment, "adjustment");
  require(out, "out");
  *out = new_fields(table(*adjustment->adjustment));
}

}  // namespace

jalon_status jalon_trajectory_adjust(const jalon_trajectory* trajectory, const jalon_cloud* cloud,
                                     const jalon_model* model, const jalon_params* options,
                                     jalon_task* task, jalon_adjustment** out) {
  return guard([&] {
    require(trajectory, "trajectory");
    require(cloud, "cloud");
    require(model, "model");
    require(out, "out");
    const std::shared_ptr<const Cloud> points = cloud->cloud;
    require_same_crs(trajectory->trajectory->crs, points->crs);
    require_same_crs(trajectory->trajectory->crs, model->model->crs);
    require_same_crs(points->crs, model->model->crs);
    const ParamSet values = options_or_default(options, "adjust");
    const auto settings = settings_from<JointSettings>(values);
    auto handle = std::make_unique<jalon_adjustment>();
    handle->trajectory = trajectory->trajectory;
    handle->model = model->model;
    handle->settings = settings;
    with_task(task, [&](Task& t) {
      JointAdjustment made =
          adjust_jointly(*handle->model, *points, *handle->trajectory, settings, t);
      made.parameters_json = values.to_json();
      handle->adjustment = std::make_shared<const JointAdjustment>(std::move(made));
    });
    *out = handle.release();
  });
}

jalon_adjustment* jalon_adjustment_retain(jalon_adjustment* adjustment) {
  return retain(adjustment);
}
void jalon_adjustment_release(jalon_adjustment* adjustment) { release(adjustment); }

jalon_status jalon_adjustment_summary(const jalon_adjustment* adjustment, jalon_fields** out) {
  return guard([&] { give_table(adjustment, out, summary_table); });
}
jalon_status jalon_adjustment_iterations(const jalon_adjustment* adjustment, jalon_fields** out) {
  return guard([&] { give_table(adjustment, out, pass_table); });
}
jalon_status jalon_adjustment_controls(const jalon_adjustment* adjustment, jalon_fields** out) {
  return guard([&] { give_table(adjustment, out, control_table); });
}
jalon_status jalon_adjustment_blocks(const jalon_adjustment* adjustment, jalon_fields** out) {
  return guard([&] { give_table(adjustment, out, block_table); });
}
jalon_status jalon_adjustment_facades(const jalon_adjustment* adjustment, jalon_fields** out) {
  return guard([&] { give_table(adjustment, out, facade_table); });
}
jalon_status jalon_adjustment_strips(const jalon_adjustment* adjustment, jalon_fields** out) {
  return guard([&] { give_table(adjustment, out, strip_table); });
}
jalon_status jalon_adjustment_matches(const jalon_adjustment* adjustment, jalon_fields** out) {
  return guard([&] { give_table(adjustment, out, match_table); });
}
jalon_status jalon_adjustment_covariance(const jalon_adjustment* adjustment, jalon_fields** out) {
  return guard([&] { give_table(adjustment, out, covariance_table); });
}

jalon_status jalon_adjustment_parameters(const jalon_adjustment* adjustment, const char** out) {
  return guard([&] {
    require(adjustment, "adjustment");
    require(out, "out");
    *out = adjustment->adjustment->parameters_json.c_str();
  });
}

jalon_status jalon_adjustment_trajectory(const jalon_adjustment* adjustment,
                                         jalon_trajectory** out) {
  return guard([&] {
    require(adjustment, "adjustment");
    require(out, "out");
    *out = new_trajectory(adjusted_trajectory(*adjustment->adjustment, *adjustment->trajectory));
  });
}

jalon_status jalon_adjustment_model(const jalon_adjustment* adjustment, jalon_model** out) {
  return guard([&] {
    require(adjustment, "adjustment");
    require(out, "out");
    const Model& given = *adjustment->model;
    Owned<jalon_model> made = own(new_model(moved_strips(given, adjustment->adjustment->model)));
    made->attributes = std::make_shared<const PartAttributes>(
        adjusted_attributes(*adjustment->adjustment, adjustment->settings, given));
    *out = made.release();
  });
}

jalon_status jalon_adjustment_apply(const jalon_adjustment* adjustment, const jalon_cloud* cloud,
                                    jalon_task* task, jalon_cloud** out) {
  return guard([&] {
    require(adjustment, "adjustment");
    require(cloud, "cloud");
    require(out, "out");
    const std::shared_ptr<const Cloud> points = cloud->cloud;
    *out = with_task(task, [&](Task& t) {
             return own(new_cloud(
                 adjusted_cloud(*adjustment->adjustment, *adjustment->trajectory, *points, t)));
           }).release();
  });
}
