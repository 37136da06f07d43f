// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/comparer.h"

#include "capi/support/comparison_handles.h"
#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "compare/distance/closest_points.h"
#include "compare/distance/model_distance.h"
#include "compare/m3c2/m3c2.h"
#include "compare/preview/preview.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

struct Method {
  const char* name;
  const char* owner;  ///< of its parameters
  std::span<const ParamRow> (*rows)();
  Comparison (*run)(const CloudPtr& reference, const CloudPtr& compared, const ParamSet&, Task&);
  Comparison (*run_model)(const ModelPtr& reference, const CloudPtr& compared, const ParamSet&, Task&);  ///< or nullptr
  /// At given core points, or nullptr.
  Comparison (*run_core)(const CloudPtr& reference, const CloudPtr& compared, const CloudPtr& core, const ParamSet&,
                         Task&);
};
constexpr Method kMethods[] = {
    {"distance", "comparer distance", distance_rows, compare_distance, compare_with_model, nullptr},
    {"m3c2", "comparer m3c2", m3c2_rows, compare_m3c2, nullptr, compare_m3c2_core},
    {"preview", "comparer preview", preview_rows, compare_preview, nullptr, nullptr},
};

const Method& method_of(const std::string& name) {
  for (const Method& method : kMethods)
    if (name == method.name) return method;
  fail(Status::kNotFound, "no comparison method \"%.100s\"; there are: distance, m3c2, preview", name.c_str());
}

// A handle of what a method made, with the parameters it was made with.
std::unique_ptr<jalon_comparison> handle_of(Comparison made, const ParamSet& values) {
  auto handle = std::make_unique<jalon_comparison>();
  made.parameters_json = values.to_json();
  handle->comparison = std::make_shared<const Comparison>(std::move(made));
  return handle;
}

}  // namespace

jalon_status jalon_comparer_create(const char* method, jalon_comparer** out) {
  return guard([&] {
    require(out, "out");
    const std::string name = method != nullptr ? require_text(method, "method") : "distance";
    const Method& found = method_of(name);
    auto handle = std::make_unique<jalon_comparer>();
    handle->method = name;
    handle->values = std::make_shared<ParamSet>(found.owner, found.rows());
    *out = handle.release();
  });
}

jalon_comparer* jalon_comparer_retain(jalon_comparer* comparer) { return retain(comparer); }
void jalon_comparer_release(jalon_comparer* comparer) { release(comparer); }

jalon_status jalon_comparer_params(jalon_comparer* comparer, jalon_params** out) {
  return give_params(comparer, "comparer", out);
}

jalon_status jalon_comparer_run(const jalon_comparer* comparer, const jalon_cloud* reference,
                                const jalon_cloud* compared, jalon_task* task, jalon_comparison** out) {
  return guard([&] {
    require(comparer, "comparer");
    require(reference, "reference");
    require(compared, "compared");
    require(out, "out");
    require_same_crs(reference->cloud->crs, compared->cloud->crs);
    const ParamSet values = *comparer->values;  // a progress callback may set the next run's
    const Method& method = method_of(comparer->method);
    *out = with_task(task, [&](Task& t) {
             return handle_of(method.run(reference->cloud, compared->cloud, values, t), values);
           }).release();
  });
}

jalon_status jalon_comparer_run_model(const jalon_comparer* comparer, const jalon_model* reference,
                                      const jalon_cloud* compared, jalon_task* task, jalon_comparison** out) {
  return guard([&] {
    require(comparer, "comparer");
    require(reference, "reference");
    require(compared, "compared");
    require(out, "out");
    require_same_crs(reference->model->crs, compared->cloud->crs);
    const ParamSet values = *comparer->values;  // a progress callback may set the next run's
    const Method& method = method_of(comparer->method);
    if (method.run_model == nullptr)
      fail(Status::kUnsupported, "method \"%s\" compares clouds only; use \"distance\"", method.name);
    *out = with_task(task, [&](Task& t) {
             return handle_of(method.run_model(reference->model, compared->cloud, values, t), values);
           }).release();
  });
}

jalon_status jalon_comparer_run_core(const jalon_comparer* comparer, const jalon_cloud* reference,
                                     const jalon_cloud* compared, const jalon_cloud* core, jalon_task* task,
                                     jalon_comparison** out) {
  return guard([&] {
    require(comparer, "comparer");
    require(reference, "reference");
    require(compared, "compared");
    require(core, "core");
    require(out, "out");
    const Method& method = method_of(comparer->method);
    if (method.run_core == nullptr)
      fail(Status::kUnsupported, "method \"%s\" has no core points; use \"m3c2\"", method.name);
    require_same_crs(reference->cloud->crs, compared->cloud->crs);
    require_same_crs(reference->cloud->crs, core->cloud->crs);
    const ParamSet values = *comparer->values;  // a progress callback may set the next run's
    *out = with_task(task, [&](Task& t) {
             return handle_of(method.run_core(reference->cloud, compared->cloud, core->cloud, values, t), values);
           }).release();
  });
}

jalon_comparison* jalon_comparison_retain(jalon_comparison* comparison) { return retain(comparison); }
void jalon_comparison_release(jalon_comparison* comparison) { release(comparison); }

jalon_status jalon_comparison_points(const jalon_comparison* comparison, jalon_fields** out) {
  return give_fields(comparison, "comparison", out, [&] { return comparison->comparison->points; });
}

jalon_status jalon_comparison_summary(const jalon_comparison* comparison, jalon_fields** out) {
  return give_fields(comparison, "comparison", out, [&] { return comparison->comparison->summary; });
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

jalon_status jalon_comparison_closest_points(const jalon_comparison* comparison, const jalon_cloud* reference,
                                             jalon_task* task, jalon_cloud** out) {
  return guard([&] {
    require(comparison, "comparison");
    require(reference, "reference");
    require(out, "out");
    *out = with_task(task, [&](Task& t) {
      return new_cloud(closest_points(*comparison->comparison, *reference->cloud, t));
    });
  });
}
