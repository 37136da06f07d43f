// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/settings_json.h"
#include "segment/codes/coded_result.h"
#include "segment/codes/grouping.h"
#include "segment/codes/step_clock.h"
#include "segment/codes/target_scene.h"
#include "segment/codes_methods.h"
#include "segment/settle/ending.h"

namespace jalon {

// The target method of feature codes (master's thesis, University of Liege 2021, 6.1):
// 1. read the table and the list; 2. walls; 3. doors; 4. windows; 5. gutters, each from what those before left;
// 6. segments, classes and notes.
Segmentation segment_by_target_codes(const CloudPtr& cloud, const TargetCodeSettings& settings,
                                     Task& task) {
  require_area(*cloud, task);
  StepClock clock(task);
  const CodeTable table =
      code_table_from_json(settings.input.table.empty() ? kTargetCodeTable : settings.input.table);
  CodedObjects objects = grouped_objects(read_code_list(settings.input.codes, table), table);
  clock.done("codes");
  TargetScene scene{*cloud, objects, settings, std::vector<uint32_t>(cloud->size(), 0)};
  const struct {
    void (*take)(TargetScene&, Task&);
    const char* name;
    double from, to;
  } steps[] = {{take_walls, "walls", 0, 0.5},
               {take_doors, "doors", 0.5, 0.55},
               {take_windows, "windows", 0.55, 0.6},
               {take_gutters, "gutters", 0.6, 0.7}};
  for (const auto& step : steps) {
    ProgressSpan span(task, step.from, step.to, step.name);
    step.take(scene, task);
    clock.done(step.name);
  }
  ProgressSpan span(task, 0.7, 1, "segments");
  warn_of_empty(*cloud, scene.owner, objects, task);
  Segmentation out = coded_segmentation(cloud, std::move(scene.owner), objects, settings.input,
                                        "target_codes", task);
  out.parameters_json = settings_json(target_code_rows(), settings);
  clock.done("segments");
  return out;
}

}  // namespace jalon
