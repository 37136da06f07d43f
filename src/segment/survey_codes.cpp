// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.h"
#include "base/settings_json.h"
#include "segment/codes/coded_result.h"
#include "segment/codes/grouping.h"
#include "segment/codes/shapes.h"
#include "segment/codes/step_clock.h"
#include "segment/codes/survey_refinement.h"
#include "segment/codes/survey_space.h"
#include "segment/codes_methods.h"
#include "segment/settle/ending.h"

namespace jalon {

namespace {

constexpr size_t kSurveyPointsPerChunk = 1 << 14;

std::vector<uint32_t> objects_of_points(const Cloud& cloud, const SurveySpace& space,
                                        const Vec3& origin, Task& task) {
  std::vector<uint32_t> object(cloud.size());
  parallel_for(task, cloud.size(), kSurveyPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) object[i] = space.object_at(cloud.point(i) - origin);
  });
  return object;
}

}  // namespace

// The survey method of feature codes (master's thesis, University of Liege 2021, 6.2):
// 1. read the table and the list; 2. join points to objects; 3. give them their shapes; 4. cut the cloud by the shapes:
// pipes, hollowed buildings, openings within them, and form "improved" moves openings and pipes to where their points
// are; 5. segments, classes and notes. What the text's script does
// otherwise than its author meant is done as meant: distances have no sign, all objects that are absent are no error.
Segmentation segment_by_survey_codes(const CloudPtr& cloud, const SurveyCodeSettings& settings,
                                     Task& task) {
  require_area(*cloud, task);
  StepClock clock(task);
  const CodeTable table =
      code_table_from_json(settings.input.table.empty() ? kSurveyCodeTable : settings.input.table);
  const CodeList list =
      read_code_list(settings.input.codes, table, metres_of(settings.input.codes_unit));
  CodedObjects objects = grouped_objects(list, table);
  give_shapes(table, objects);
  clock.done("codes");
  std::vector<uint32_t> object_of_point = [&] {
    ProgressSpan span(task, 0, 0.5, "cutting");
    return objects_of_points(*cloud, SurveySpace(table, objects, settings), objects.origin, task);
  }();
  clock.done("points cut");
  if (settings.input.form == CodeForm::kImproved) {
    refine_survey(*cloud, table, objects, settings, object_of_point, task);
    clock.done("refined");
  }
  warn_of_shifted_pipes(*cloud, objects, task);
  ProgressSpan span(task, 0.5, 1, "segments");
  warn_of_empty(*cloud, object_of_point, objects, task);
  Segmentation out = coded_segmentation(cloud, std::move(object_of_point), objects, settings.input,
                                        "survey_codes", task);
  out.parameters_json = settings_json(survey_code_rows(), settings);
  clock.done("segments");
  return out;
}

}  // namespace jalon
