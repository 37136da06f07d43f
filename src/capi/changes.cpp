// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/changes.h"

#include "capi/comparison_handles.h"
#include "capi/guard.h"
#include "compare/regions.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_comparison_regions(const jalon_comparison* comparison, const jalon_params* options,
                                      jalon_task* task, jalon_fields** out_points, jalon_fields** out_regions) {
  return guard([&] {
    require(comparison, "comparison");
    const ParamSet set = options_or_default(options, "regions");
    auto tables = with_task(task, [&](Task& t) {
      const Regions found = change_regions(*comparison->comparison, set, t);
      return std::pair(own(new_fields(region_points_table(found))), own(new_fields(regions_table(found))));
    });
    if (out_points != nullptr) *out_points = tables.first.release();
    if (out_regions != nullptr) *out_regions = tables.second.release();
  });
}
