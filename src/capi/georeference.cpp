// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/georeference.h"

#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "capi/support/trajectory_handles.h"
#include "scan/mobile/cloud_ellipsoids.h"
#include "scan/mobile/georeference.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

std::span<const double> values_of_returns(const double* values, uint64_t count, const char* name) {
  require_array(values, JALON_FLOAT64, count, 1, 0, name);
  return {values, static_cast<size_t>(count)};
}

}  // namespace

jalon_status jalon_trajectory_georeference(const jalon_trajectory* trajectory,
                                           const double* times_s, const double* ranges_m,
                                           const double* thetas_rad, const double* phis_rad,
                                           uint64_t count, const jalon_params* options,
                                           jalon_task* task, jalon_cloud** out) {
  return guard([&] {
    require(trajectory, "trajectory");
    require(out, "out");
    const LaserReturns returns{values_of_returns(times_s, count, "times_s"),
                               values_of_returns(ranges_m, count, "ranges_m"),
                               values_of_returns(thetas_rad, count, "thetas_rad"),
                               values_of_returns(phis_rad, count, "phis_rad")};
    const auto settings =
        settings_from<GeoreferenceSettings>(options_or_default(options, "georeference"));
    *out = with_task(task, [&](Task& t) {
             return own(new_cloud(georeferenced(*trajectory->trajectory, returns, settings, t)));
           }).release();
  });
}

jalon_status jalon_cloud_ellipsoids(const jalon_cloud* cloud, const jalon_params* options,
                                    jalon_task* task, jalon_model** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const auto settings =
        settings_from<EllipsoidSettings>(options_or_default(options, "ellipsoids"));
    *out = with_task(task, [&](Task& t) {
             return own(new_model(cloud_ellipsoids(*cloud->cloud, settings, t)));
           }).release();
  });
}
