// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/field_tools.h"

#include "base/table_columns.h"
#include "capi/support/guard.h"
#include "capi/support/noise_law_handle.h"
#include "fieldtools/chamfer.h"
#include "fieldtools/chi_square.h"
#include "fieldtools/fast_marching.h"
#include "fieldtools/field_arithmetic.h"
#include "fieldtools/field_values.h"
#include "fieldtools/gradient.h"
#include "fieldtools/propagation.h"
#include "fieldtools/smoothing.h"
#include "fieldtools/two_means.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

/// Runs change(cloud, task) and puts the result in place of the handle's cloud.
template <class F>
void change_cloud_of_field_tools(jalon_cloud* cloud, jalon_task* task, F&& change) {
  auto changed = with_task(
      task, [&](Task& t) { return std::make_shared<const Cloud>(change(*cloud->cloud, t)); });
  cloud->cloud = std::move(changed);
}

/// The same where change also fills a table.
template <class F>
void change_cloud_with_table(jalon_cloud* cloud, jalon_task* task, jalon_fields** out, F&& change) {
  Owned<jalon_fields> made = own<jalon_fields>(nullptr);
  change_cloud_of_field_tools(cloud, task, [&](const Cloud& c, Task& t) {
    FieldTable table;
    Cloud changed = change(c, t, table);
    made.reset(new_fields(std::move(table)));
    return changed;
  });
  *out = made.release();
}

FieldTable filter_table(const ChangeFilter& found) {
  FieldTable t;
  add_value<uint64_t>(t, "tested", "points", "with enough values around", found.tested);
  add_value<uint64_t>(t, "not_tested", "points", "without", found.distance.size() - found.tested);
  add_value<uint64_t>(t, "second_pass", "points", "tested again with more neighbours",
                      found.second_pass);
  add_value<uint64_t>(t, "changed", "points", "above the cut", found.changed_count);
  add_value<double>(t, "threshold", "1", "the cut", found.threshold);
  add_value<double>(t, "ceiling", "1", "where distances saturate", found.ceiling);
  return t;
}

FieldTable class_table(const FieldClasses& found) {
  FieldTable t;
  add_value<double>(t, "low_cut", "", "between groups 0 and 1", found.low_cut);
  add_value<double>(t, "high_cut", "", "between groups 1 and 2", found.high_cut);
  add_value<double>(t, "centre_0", "", "mean of group 0", found.low_centre);
  add_value<double>(t, "centre_1", "", "mean of group 1", found.middle_centre);
  add_value<double>(t, "centre_2", "", "mean of group 2", found.high_centre);
  add_value<uint64_t>(t, "count_0", "points", "of group 0", found.counts[0]);
  add_value<uint64_t>(t, "count_1", "points", "of group 1", found.counts[1]);
  add_value<uint64_t>(t, "count_2", "points", "of group 2", found.counts[2]);
  add_value<uint64_t>(t, "missing", "points", "without a value", found.missing);
  return t;
}

}  // namespace

jalon_status jalon_cloud_compute_chi_square(jalon_cloud* cloud, const char* field,
                                            const jalon_noise_law* law, const jalon_params* options,
                                            jalon_task* task, jalon_fields** summary) {
  return guard([&] {
    require(cloud, "cloud");
    require(law, "law");
    require(summary, "summary");
    const std::string from = require_text(field, "field");
    const auto chosen = settings_from<ChiSquareSettings>(options_or_default(options, "chi_square"));
    const std::string name = chosen.distance_field();
    const std::string changed_name = require_field_name(chosen.changed);
    change_cloud_with_table(cloud, task, summary, [&](const Cloud& c, Task& t, FieldTable& table) {
      const ChangeFilter found = filter_changes(c, scalar_values(c, from, t), law->law, chosen, t);
      table = filter_table(found);
      const Cloud tested = with_field<double>(
          c, name, "1", "distance of the values around it from the noise law", found.distance);
      return with_field<uint8_t>(tested, changed_name, "",
                                 "1 = the values around do not follow the noise law",
                                 found.changed);
    });
  });
}

jalon_status jalon_cloud_classify_field(jalon_cloud* cloud, const char* field,
                                        const jalon_params* options, jalon_task* task,
                                        jalon_fields** summary) {
  return guard([&] {
    require(cloud, "cloud");
    require(summary, "summary");
    const std::string from = require_text(field, "field");
    const auto chosen = settings_from<ClassesSettings>(options_or_default(options, "classes"));
    const std::string name = require_field_name(chosen.name);
    change_cloud_with_table(cloud, task, summary, [&](const Cloud& c, Task& t, FieldTable& table) {
      const FieldClasses found = classify_values(scalar_values(c, from, t), chosen, t);
      table = class_table(found);
      return with_field<uint8_t>(c, name, "", "group by value; 255 = no value", found.group);
    });
  });
}

jalon_status jalon_cloud_compute_gradient(jalon_cloud* cloud, const char* field,
                                          const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    const std::string from = require_text(field, "field");
    const auto chosen = settings_from<GradientSettings>(options_or_default(options, "gradient"));
    change_cloud_of_field_tools(
        cloud, task, [&](const Cloud& c, Task& t) { return with_gradient(c, from, chosen, t); });
  });
}

jalon_status jalon_cloud_filter_field(jalon_cloud* cloud, const char* field,
                                      const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    const std::string from = require_text(field, "field");
    const auto chosen =
        settings_from<FieldFilterSettings>(options_or_default(options, "field_filter"));
    change_cloud_of_field_tools(cloud, task, [&](const Cloud& c, Task& t) {
      return with_filtered_field(c, from, chosen, t);
    });
  });
}

jalon_status jalon_cloud_compute_field(jalon_cloud* cloud, const char* field, const char* other,
                                       const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    const std::string a = require_text(field, "field"),
                      b = other != nullptr ? require_text(other, "other") : "";
    if (other != nullptr && b.empty()) fail(Status::kInvalidArgument, "other is an empty name");
    const auto chosen =
        settings_from<FieldArithmeticSettings>(options_or_default(options, "field_arithmetic"));
    change_cloud_of_field_tools(cloud, task, [&](const Cloud& c, Task& t) {
      return with_computed_field(c, a, b, chosen, t);
    });
  });
}

jalon_status jalon_cloud_compute_geodesic(jalon_cloud* cloud, const uint64_t* seeds, uint64_t count,
                                          const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    require_array(seeds, JALON_UINT64, count, 1, 0, "seeds");
    const auto chosen = settings_from<GeodesicSettings>(options_or_default(options, "geodesic"));
    change_cloud_of_field_tools(cloud, task, [&](const Cloud& c, Task& t) {
      return with_geodesic_distance(c, {seeds, static_cast<size_t>(count)}, chosen, t);
    });
  });
}

jalon_status jalon_cloud_segment_propagation(jalon_cloud* cloud, const char* field,
                                             const char* gradient_field,
                                             const jalon_params* options, jalon_task* task,
                                             jalon_fields** regions) {
  return guard([&] {
    require(cloud, "cloud");
    require(regions, "regions");
    const std::string from = require_text(field, "field"),
                      slope = require_text(gradient_field, "gradient_field");
    const auto chosen =
        settings_from<PropagationSettings>(options_or_default(options, "propagation"));
    const std::string name = require_field_name(chosen.name), arrival = chosen.arrival_name;
    change_cloud_with_table(cloud, task, regions, [&](const Cloud& c, Task& t, FieldTable& table) {
      PropagationResult found = segment_by_propagation(c, scalar_values(c, from, t),
                                                       scalar_values(c, slope, t), chosen, t);
      table = std::move(found.regions);
      Cloud out = with_field<uint32_t>(
          c, name, "", "region by propagation, 1 = most points, 0 = none", found.labels);
      return arrival.empty()
                 ? out
                 : with_field<double>(out, arrival, "m", "arrival time of the front, m at speed 1",
                                      found.arrival_m);
    });
  });
}

jalon_status jalon_cloud_compute_map_distance(jalon_cloud* cloud, const jalon_cloud* reference,
                                              const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    require(reference, "reference");
    const auto chosen =
        settings_from<DistanceMapSettings>(options_or_default(options, "distance_map"));
    const CloudPtr from = reference->cloud;  // it may be the same handle
    change_cloud_of_field_tools(cloud, task, [&](const Cloud& c, Task& t) {
      return with_map_distance(c, *from, chosen, t);
    });
  });
}

jalon_status jalon_cloud_distance_map(const jalon_cloud* cloud, const jalon_params* options,
                                      jalon_task* task, jalon_cloud** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const auto chosen =
        settings_from<DistanceMapSettings>(options_or_default(options, "distance_map"));
    *out = with_task(task, [&](Task& t) {
             return own(new_cloud(distance_map_cloud(*cloud->cloud, chosen, t)));
           }).release();
  });
}
