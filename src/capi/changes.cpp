// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/changes.h"

#include "capi/support/comparison_handles.h"
#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "compare/changes/diagnosis.h"
#include "report/pages/change_outlines.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_comparison_regions(const jalon_comparison* comparison,
                                      const jalon_params* options, jalon_task* task,
                                      jalon_fields** out_points, jalon_fields** out_regions) {
  return guard([&] {
    require(comparison, "comparison");
    const auto settings = settings_from<RegionSettings>(options_or_default(options, "regions"));
    auto tables = with_task(task, [&](Task& t) {
      const ChangeRegions found = change_regions(*comparison->comparison, settings, t);
      return std::pair(own(new_fields(region_points_table(found))),
                       own(new_fields(regions_table(found))));
    });
    if (out_points != nullptr) *out_points = tables.first.release();
    if (out_regions != nullptr) *out_regions = tables.second.release();
  });
}

jalon_status jalon_comparison_diagnose(const jalon_comparison* forward,
                                       const jalon_comparison* reverse, const jalon_params* options,
                                       jalon_task* task, jalon_fields** out_forward,
                                       jalon_fields** out_reverse, jalon_fields** out_changes) {
  return guard([&] {
    require(forward, "forward");
    require(reverse, "reverse");
    const auto settings = settings_from<RegionSettings>(options_or_default(options, "diagnosis"));
    struct Tables {
      Owned<jalon_fields> forward, reverse, changes;
    };
    Tables made = with_task(task, [&](Task& t) {
      const Diagnosis found = diagnose(*forward->comparison, *reverse->comparison, settings, t);
      // Each takes tens of milliseconds of a cloud of millions: a look before and behind each.
      const auto table_of = [&](FieldTable table) {
        t.checkpoint(1);
        return own(new_fields(std::move(table)));
      };
      t.checkpoint(1);
      auto after = table_of(diagnosis_points_table(found, true));
      auto before = table_of(diagnosis_points_table(found, false));
      return Tables{std::move(after), std::move(before), table_of(changes_table(found))};
    });
    if (out_forward != nullptr) *out_forward = made.forward.release();
    if (out_reverse != nullptr) *out_reverse = made.reverse.release();
    if (out_changes != nullptr) *out_changes = made.changes.release();
  });
}

jalon_status jalon_comparison_outlines(const jalon_comparison* forward,
                                       const jalon_fields* forward_points,
                                       const jalon_comparison* reverse,
                                       const jalon_fields* reverse_points,
                                       const jalon_fields* changes, const jalon_params* options,
                                       jalon_task* task, jalon_model** out) {
  return guard([&] {
    require(forward, "forward");
    require(forward_points, "forward_points");
    if (reverse != nullptr) require(reverse_points, "reverse_points");
    require(out, "out");
    const auto settings =
        settings_from<ChangeOutlineSettings>(options_or_default(options, "change_outlines"));
    const ChangedCloud after{forward->comparison.get(), &forward_points->table};
    ChangedCloud before;
    if (reverse != nullptr) before = {reverse->comparison.get(), &reverse_points->table};
    const FieldTable* table = changes != nullptr ? &changes->table : nullptr;
    *out = with_task(task, [&](Task& t) {
      return new_model(change_outlines(after, before, table, settings, t));
    });
  });
}
