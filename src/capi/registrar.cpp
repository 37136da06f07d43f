// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/registrar.h"

#include <cmath>
#include <vector>

#include "capi/support/comparison_handles.h"
#include "capi/support/guard.h"
#include "capi/support/methods.h"
#include "capi/support/registration_handles.h"
#include "registration/targets/targets.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

// A handle of what a method made, with the parameters it was made with.
std::unique_ptr<jalon_registration> handle_of(Registration made, const ParamSet& values,
                                              const SharedText& crs) {
  auto handle = std::make_unique<jalon_registration>();
  made.parameters_json = values.to_json();
  handle->registration = std::make_shared<const Registration>(std::move(made));
  handle->crs = crs;
  return handle;
}

std::vector<Target> targets_from(const jalon_target* targets, uint64_t count, const char* what) {
  constexpr uint64_t kMost = 1'000'000;
  if (count > 0) require(targets, what);
  if (count > kMost)
    fail(Status::kLimit, "%llu %s targets; at most a million",
         static_cast<unsigned long long>(count), what);
  std::vector<Target> out(static_cast<size_t>(count));
  for (size_t i = 0; i < out.size(); ++i) {
    if (targets[i].name != nullptr) out[i].name = require_text(targets[i].name, "name");
    out[i].xyz = from_c(targets[i].xyz);
    if (!is_finite(out[i].xyz))
      fail(Status::kInvalidArgument, "%s target %zu has a coordinate that is not finite", what, i);
    for (size_t k = 0; k < 9; ++k) {
      if (!std::isfinite(targets[i].covariance[k]))
        fail(Status::kInvalidArgument, "%s target %zu has a covariance that is not finite", what,
             i);
      out[i].covariance[k] = targets[i].covariance[k];
    }
  }
  return out;
}

}  // namespace

jalon_status jalon_registrar_create(const char* method, jalon_registrar** out) {
  return create_worker(registration_methods(), method, "registration method", out);
}

jalon_status jalon_registrar_methods(const char* const** names, uint64_t* count) {
  return guard([&] { give_names(registration_method_names(), names, count); });
}

jalon_status jalon_registrar_copy(const jalon_registrar* registrar, jalon_registrar** out) {
  return copy_worker(registrar, "registrar", out);
}

jalon_registrar* jalon_registrar_retain(jalon_registrar* registrar) { return retain(registrar); }
void jalon_registrar_release(jalon_registrar* registrar) { release(registrar); }

jalon_status jalon_registrar_params(jalon_registrar* registrar, jalon_params** out) {
  return give_worker_params(registrar, "registrar", out);
}

jalon_status jalon_registrar_run(const jalon_registrar* registrar, const jalon_cloud* reference,
                                 const jalon_cloud* moving, const jalon_transform* start,
                                 jalon_task* task, jalon_registration** out) {
  return guard([&] {
    require(registrar, "registrar");
    require(reference, "reference");
    require(moving, "moving");
    require(out, "out");
    require_same_crs(reference->cloud->crs, moving->cloud->crs);
    const Transform from = start != nullptr ? from_c(*start) : Transform{};
    require_rigid(from, "the start");
    const RegistrationMethod& method = *registrar->method;
    if (method.run == nullptr)
      fail(Status::kUnsupported, "method \"%s\" registers targets, not clouds", method.name);
    *out = run_worker(*registrar, task, [&](const ParamSet& values, Task& t) {
             return handle_of(method.run(reference->cloud, moving->cloud, from, values, t), values,
                              reference->cloud->crs);
           }).release();
  });
}

jalon_status jalon_registrar_run_targets(const jalon_registrar* registrar,
                                         const jalon_target* reference, uint64_t reference_count,
                                         const jalon_target* moving, uint64_t moving_count,
                                         jalon_task* task, jalon_registration** out) {
  return guard([&] {
    require(registrar, "registrar");
    require(out, "out");
    const std::vector<Target> to = targets_from(reference, reference_count, "reference");
    const std::vector<Target> from = targets_from(moving, moving_count, "moving");
    const auto run = require_run(registration_methods(), *registrar->method,
                                 &RegistrationMethod::run_targets, "registers clouds");
    *out = run_worker(*registrar, task, [&](const ParamSet& values, Task& t) {
             return handle_of(run(to, from, values, t), values, {});
           }).release();
  });
}

jalon_registration* jalon_registration_retain(jalon_registration* registration) {
  return retain(registration);
}
void jalon_registration_release(jalon_registration* registration) { release(registration); }

jalon_status jalon_registration_pose(const jalon_registration* registration,
                                     jalon_transform* T_reference_moving) {
  return guard([&] {
    require(registration, "registration");
    require(T_reference_moving, "T_reference_moving");
    *T_reference_moving = to_c(registration->registration->pose);
  });
}

jalon_status jalon_registration_summary(const jalon_registration* registration,
                                        jalon_fields** out) {
  return give_fields(registration, "registration", out,
                     [&] { return registration->registration->summary; });
}

jalon_status jalon_registration_iterations(const jalon_registration* registration,
                                           jalon_fields** out) {
  return give_fields(registration, "registration", out,
                     [&] { return registration->registration->iteration_log; });
}

jalon_status jalon_registration_residuals(const jalon_registration* registration,
                                          jalon_fields** out) {
  return give_fields(registration, "registration", out,
                     [&] { return registration->registration->residuals; });
}

jalon_status jalon_registration_pair_name(const jalon_registration* registration, uint64_t i,
                                          const char** out) {
  return guard([&] {
    require(registration, "registration");
    require(out, "out");
    const Registration& r = *registration->registration;
    const uint64_t rows = r.residuals.size() > 0 ? r.residuals.at(0)->count() : 0;
    if (i >= rows)
      fail(Status::kInvalidArgument, "pair %llu of %llu", static_cast<unsigned long long>(i),
           static_cast<unsigned long long>(rows));
    *out = i < r.pair_names.size() ? r.pair_names[i].c_str() : "";
  });
}

jalon_status jalon_registration_directions(const jalon_registration* registration,
                                           jalon_fields** out) {
  return give_fields(registration, "registration", out,
                     [&] { return registration->registration->directions; });
}

jalon_status jalon_registration_reasons(const jalon_registration* registration, const char** out) {
  return guard([&] {
    require(registration, "registration");
    require(out, "out");
    *out = registration->registration->judgement.reasons.c_str();
  });
}

jalon_status jalon_registration_parameters(const jalon_registration* registration,
                                           const char** out) {
  return guard([&] {
    require(registration, "registration");
    require(out, "out");
    *out = registration->registration->parameters_json.c_str();
  });
}
