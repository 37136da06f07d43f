// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "capi/support/comparison_handles.h"
#include "capi/support/methods.h"
#include "capi/support/registration_handles.h"
#include "cloud/operations.h"
#include "jalon/registrar.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_registration_apply(const jalon_registration* registration,
                                      const jalon_cloud* cloud, jalon_task* task,
                                      jalon_cloud** out) {
  return guard([&] {
    require(registration, "registration");
    require(cloud, "cloud");
    require(out, "out");
    *out = with_task(task, [&](Task& t) {
             Cloud moved = transformed(*cloud->cloud, registration->registration->pose, t);
             if (moved.crs.empty()) moved.crs = registration->crs;
             return own(new_cloud(std::move(moved)));
           }).release();
  });
}

jalon_status jalon_comparer_use_registration(jalon_comparer* comparer,
                                             const jalon_registration* registration) {
  return guard([&] {
    require(comparer, "comparer");
    require(registration, "registration");
    const auto use = require_run(compare_methods(), *comparer->method,
                                 &CompareMethod::use_registration, "has no level of detection");
    const Registration& r = *registration->registration;
    for (const double value : r.covariance)
      if (!std::isfinite(value))
        fail(Status::kDegenerate,
             "the registration leaves %llu directions open; it has no covariance there",
             static_cast<unsigned long long>(r.unobservable));
    use(r.covariance, r.centre, *comparer->values);
  });
}
