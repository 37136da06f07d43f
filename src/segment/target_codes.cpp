// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>

#include "base/settings_json.h"
#include "segment/codes/coded_result.h"
#include "segment/codes/grouping.h"
#include "segment/codes/step_clock.h"
#include "segment/codes/target_scene.h"
#include "segment/codes_methods.h"
#include "segment/settle/ending.h"

namespace jalon {

namespace {

constexpr double kStepsShare = 0.7;

struct TargetStep {
  void (*take)(TargetScene&, Task&);
  const char* name;
};

// The object of each point; what is known of places goes with the scene.
std::vector<uint32_t> owners(const Cloud& cloud, CodedObjects& objects,
                             const TargetCodeSettings& settings, StepClock& clock, Task& task) {
  TargetScene scene(cloud, objects, settings, task);
  clock.done("tiles");
  std::vector<TargetStep> steps{
      {take_walls, "walls"}, {take_doors, "doors"}, {take_windows, "windows"}};
  // A wall takes what stands out of it by less than its distance.
  steps.insert(scene.is_improved() ? steps.begin() : steps.end(), {take_gutters, "gutters"});
  if (scene.is_improved()) steps.push_back({take_reveals, "reveals"});
  for (size_t k = 0; k < steps.size(); ++k) {
    const double share = kStepsShare / static_cast<double>(steps.size());
    ProgressSpan span(task, share * static_cast<double>(k), share * static_cast<double>(k + 1),
                      steps[k].name);
    steps[k].take(scene, task);
    clock.done(steps[k].name);
  }
  return std::move(scene.owner);
}

// Whether two targets of windows stick on one facade; the cloud is looked at only when that is asked.
ArePaired pairs_by_patches(const Cloud& cloud, const CodeList& list,
                           const TargetCodeSettings& settings, Task& task) {
  struct Patches {
    CodedObjects none;
    std::optional<TargetScene> scene;
  };
  const auto patches = std::make_shared<Patches>();
  return [&, patches](const CodedPoint& a, const CodedPoint& b) {
    if (!patches->scene) {
      patches->none.origin = list.points.front().position;
      patches->scene.emplace(cloud, patches->none, settings, task);
    }
    return are_on_one_facade(*patches->scene, a, b);
  };
}

}  // namespace

// The target method of feature codes (master's thesis, University of Liege 2021, 6.1):
// 1. read the table and the list; 2. walls; 3. doors; 4. windows; 5. gutters, each from what those before left
// (form "improved": gutters first, at last the reveals of what was found go to the walls);
// 6. segments, classes and notes.
Segmentation segment_by_target_codes(const CloudPtr& cloud, const TargetCodeSettings& settings,
                                     Task& task) {
  require_area(*cloud, task);
  StepClock clock(task);
  const CodeTable table =
      code_table_from_json(settings.input.table.empty() ? kTargetCodeTable : settings.input.table);
  const CodeList list =
      read_code_list(settings.input.codes, table, metres_of(settings.input.codes_unit));
  CodedObjects objects =
      grouped_objects(list, table, pairs_by_patches(*cloud, list, settings, task));
  clock.done("codes");
  std::vector<uint32_t> owner = owners(*cloud, objects, settings, clock, task);
  ProgressSpan span(task, kStepsShare, 1, "segments");
  warn_of_empty(*cloud, owner, objects, task);
  Segmentation out =
      coded_segmentation(cloud, std::move(owner), objects, settings.input, "target_codes", task);
  out.parameters_json = settings_json(target_code_rows(), settings);
  clock.done("segments");
  return out;
}

}  // namespace jalon
