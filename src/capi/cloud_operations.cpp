// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "capi/support/cloud_handle.h"
#include "cloud/statistics.h"

namespace jalon::capi {

namespace {

/// Runs change(cloud, task) and puts the result in place of the handle's cloud.
template <class F>
void change_cloud_of_cloud_operations(jalon_cloud* cloud, jalon_task* task, F&& change) {
  auto changed = with_task(
      task, [&](Task& t) { return std::make_shared<const Cloud>(change(*cloud->cloud, t)); });
  cloud->cloud = std::move(changed);
}

/// Runs reduce(cloud, task) and hands out what is left, with the report.
template <class F>
void reduce_cloud(const jalon_cloud* cloud, jalon_task* task, jalon_cloud** out,
                  jalon_reduction* report, F&& reduce) {
  auto reduced = with_task(task, [&](Task& t) { return own(new_cloud(reduce(*cloud->cloud, t))); });
  const Reduction r = reduction_of(cloud->cloud->size(), reduced->cloud->size());
  *out = reduced.release();
  if (report != nullptr) *report = {r.count_in, r.count_out, r.removed, r.removed_percent};
}

}  // namespace

}  // namespace jalon::capi

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_cloud_compute_normals(jalon_cloud* cloud, const jalon_params* options,
                                         jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    const auto chosen = settings_from<NormalsSettings>(options_or_default(options, "normals"));
    change_cloud_of_cloud_operations(
        cloud, task, [&](const Cloud& c, Task& t) { return with_normals(c, chosen, t); });
  });
}

jalon_status jalon_cloud_invert_normals(jalon_cloud* cloud, jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    change_cloud_of_cloud_operations(
        cloud, task, [](const Cloud& c, Task& t) { return with_inverted_normals(c, t); });
  });
}

jalon_status jalon_cloud_compute_features(jalon_cloud* cloud, const jalon_params* options,
                                          jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    const auto chosen = settings_from<FeaturesSettings>(options_or_default(options, "features"));
    change_cloud_of_cloud_operations(
        cloud, task, [&](const Cloud& c, Task& t) { return with_features(c, chosen, t); });
  });
}

jalon_status jalon_cloud_compute_components(jalon_cloud* cloud, const jalon_params* options,
                                            jalon_task* task, uint64_t* out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const auto chosen =
        settings_from<ComponentsSettings>(options_or_default(options, "components"));
    uint64_t count = 0;
    change_cloud_of_cloud_operations(
        cloud, task, [&](const Cloud& c, Task& t) { return with_components(c, chosen, t, count); });
    *out = count;
  });
}

jalon_status jalon_cloud_covariance(const jalon_cloud* cloud, jalon_task* task,
                                    jalon_vec3* centroid, double covariance[9]) {
  return guard([&] {
    require(cloud, "cloud");
    const CloudCovariance whole =
        with_task(task, [&](Task& t) { return covariance_of(*cloud->cloud, t); });
    if (centroid != nullptr) *centroid = to_c(whole.centroid);
    if (covariance == nullptr) return;
    constexpr size_t kUpper[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
    for (size_t i = 0; i < 9; ++i) covariance[i] = whole.covariance[kUpper[i]];
  });
}

jalon_status jalon_cloud_moment(const jalon_cloud* cloud, uint32_t a, uint32_t b, uint32_t c,
                                int32_t centred, jalon_task* task, double* out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    constexpr uint32_t kMaxPower = 8;
    if (std::max({a, b, c}) > kMaxPower)
      fail(Status::kInvalidArgument, "powers %u, %u, %u; at most %u each", a, b, c, kMaxPower);
    *out = with_task(task,
                     [&](Task& t) { return moment_of(*cloud->cloud, a, b, c, centred != 0, t); });
  });
}

jalon_status jalon_cloud_remove_duplicates(const jalon_cloud* cloud, double tolerance_m,
                                           jalon_task* task, jalon_cloud** out,
                                           jalon_reduction* report) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    reduce_cloud(cloud, task, out, report,
                 [&](const Cloud& c, Task& t) { return without_duplicates(c, tolerance_m, t); });
  });
}

jalon_status jalon_cloud_remove_outliers(const jalon_cloud* cloud, const jalon_params* options,
                                         jalon_task* task, jalon_cloud** out,
                                         jalon_reduction* report) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const auto chosen = settings_from<OutliersSettings>(options_or_default(options, "outliers"));
    reduce_cloud(cloud, task, out, report,
                 [&](const Cloud& c, Task& t) { return without_outliers(c, chosen, t); });
  });
}

jalon_status jalon_cloud_subsample(const jalon_cloud* cloud, const jalon_params* options,
                                   jalon_task* task, jalon_cloud** out, jalon_reduction* report) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const auto chosen = settings_from<SubsampleSettings>(options_or_default(options, "subsample"));
    reduce_cloud(cloud, task, out, report,
                 [&](const Cloud& c, Task& t) { return subsampled(c, chosen, t); });
  });
}
