// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/comparer.h"

#include "capi/support/comparison_handles.h"
#include "capi/support/methods.h"
#include "capi/support/model_handles.h"
#include "compare/distance/closest_points.h"
#include "compare/overlap/overlap.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

// A handle of what a method made, with the parameters it was made with.
std::unique_ptr<jalon_comparison> handle_of(Comparison made, const ParamSet& values) {
  auto handle = std::make_unique<jalon_comparison>();
  made.parameters_json = values.to_json();
  handle->comparison = std::make_shared<const Comparison>(std::move(made));
  return handle;
}

}  // namespace

jalon_status jalon_cloud_overlap(const jalon_cloud* reference, const jalon_cloud* compared,
                                 jalon_task* task, jalon_fields** out) {
  return guard([&] {
    require(reference, "reference");
    require(compared, "compared");
    require(out, "out");
    *out = with_task(task, [&](Task& t) {
             return own(
                 new_fields(overlap_table(clouds_overlap(*reference->cloud, *compared->cloud, t))));
           }).release();
  });
}

jalon_status jalon_comparer_create(const char* method, jalon_comparer** out) {
  return create_worker(compare_methods(), method, "comparison method", out);
}

jalon_status jalon_comparer_methods(const char* const** names, uint64_t* count) {
  return guard([&] { give_names(compare_method_names(), names, count); });
}

jalon_status jalon_comparer_copy(const jalon_comparer* comparer, jalon_comparer** out) {
  return copy_worker(comparer, "comparer", out);
}

jalon_comparer* jalon_comparer_retain(jalon_comparer* comparer) { return retain(comparer); }
void jalon_comparer_release(jalon_comparer* comparer) { release(comparer); }

jalon_status jalon_comparer_params(jalon_comparer* comparer, jalon_params** out) {
  return give_worker_params(comparer, "comparer", out);
}

jalon_status jalon_comparer_run(const jalon_comparer* comparer, const jalon_cloud* reference,
                                const jalon_cloud* compared, jalon_task* task,
                                jalon_comparison** out) {
  return guard([&] {
    require(comparer, "comparer");
    require(reference, "reference");
    require(compared, "compared");
    require(out, "out");
    require_same_crs(reference->cloud->crs, compared->cloud->crs);
    const CompareMethod& method = *comparer->method;
    *out = run_worker(*comparer, task, [&](const ParamSet& values, Task& t) {
             return handle_of(method.run(reference->cloud, compared->cloud, values, t), values);
           }).release();
  });
}

jalon_status jalon_comparer_run_model(const jalon_comparer* comparer, const jalon_model* reference,
                                      const jalon_cloud* compared, jalon_task* task,
                                      jalon_comparison** out) {
  return guard([&] {
    require(comparer, "comparer");
    require(reference, "reference");
    require(compared, "compared");
    require(out, "out");
    require_same_crs(reference->model->crs, compared->cloud->crs);
    const auto run = require_run(compare_methods(), *comparer->method, &CompareMethod::run_model,
                                 "compares clouds only");
    *out = run_worker(*comparer, task, [&](const ParamSet& values, Task& t) {
             return handle_of(run(reference->model, compared->cloud, values, t), values);
           }).release();
  });
}

jalon_status jalon_comparer_run_core(const jalon_comparer* comparer, const jalon_cloud* reference,
                                     const jalon_cloud* compared, const jalon_cloud* core,
                                     jalon_task* task, jalon_comparison** out) {
  return guard([&] {
    require(comparer, "comparer");
    require(reference, "reference");
    require(compared, "compared");
    require(core, "core");
    require(out, "out");
    const auto run = require_run(compare_methods(), *comparer->method, &CompareMethod::run_core,
                                 "has no core points");
    require_same_crs(reference->cloud->crs, compared->cloud->crs);
    require_same_crs(reference->cloud->crs, core->cloud->crs);
    *out =
        run_worker(*comparer, task, [&](const ParamSet& values, Task& t) {
          return handle_of(run(reference->cloud, compared->cloud, core->cloud, values, t), values);
        }).release();
  });
}

jalon_comparison* jalon_comparison_retain(jalon_comparison* comparison) {
  return retain(comparison);
}
void jalon_comparison_release(jalon_comparison* comparison) { release(comparison); }

jalon_status jalon_comparison_points(const jalon_comparison* comparison, jalon_fields** out) {
  return give_fields(comparison, "comparison", out, [&] { return comparison->comparison->points; });
}

jalon_status jalon_comparison_summary(const jalon_comparison* comparison, jalon_fields** out) {
  return give_fields(comparison, "comparison", out,
                     [&] { return comparison->comparison->summary; });
}

jalon_status jalon_comparison_parts(const jalon_comparison* comparison, jalon_fields** out) {
  return give_fields(comparison, "comparison", out, [&] { return comparison->comparison->parts; });
}

jalon_status jalon_comparison_cloud(const jalon_comparison* comparison, jalon_cloud** out) {
  return guard([&] {
    require(comparison, "comparison");
    require(out, "out");
    Cloud cloud = *comparison->comparison->cloud;
    for (const ColumnPtr& column : comparison->comparison->points) cloud.fields.set(column);
    *out = new_cloud(std::move(cloud));
  });
}

jalon_status jalon_comparison_parameters(const jalon_comparison* comparison, const char** out) {
  return guard([&] {
    require(comparison, "comparison");
    require(out, "out");
    *out = comparison->comparison->parameters_json.c_str();
  });
}

jalon_status jalon_comparison_closest_points(const jalon_comparison* comparison,
                                             const jalon_cloud* reference, jalon_task* task,
                                             jalon_cloud** out) {
  return guard([&] {
    require(comparison, "comparison");
    require(reference, "reference");
    require(out, "out");
    *out = with_task(task, [&](Task& t) {
      return new_cloud(closest_points(*comparison->comparison, *reference->cloud, t));
    });
  });
}
