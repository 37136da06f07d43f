// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "coded_drawn.h"
#include "modelling/codes/coded_model.h"
#include "segment/codes/notes_reader.h"

namespace jalon::test {

inline constexpr uint8_t kNoClass = 255;

/// What a method makes of a scan; points in the order of the yard's scan.
struct Coded {
  std::vector<uint8_t> classes;  ///< kNoClass: a point that the variant has not
  std::vector<int64_t> objects;  ///< number in the list's order, 0: none
  std::vector<std::string> warned;
  std::vector<DrawnObject> drawn;
};

inline Coded coded_of(const CodedYard& yard, const CodedVariant& variant, bool by_survey,
                      CodeForm form) {
  Task task;
  const CloudPtr cloud = cloud_of(yard, variant);
  const Segmentation coded = [&] {
    if (by_survey) {
      SurveyCodeSettings settings;
      settings.input.form = form;
      settings.input.codes = moved_list(yard.survey, variant.motion);
      return segment_by_survey_codes(cloud, settings, task);
    }
    TargetCodeSettings settings;
    settings.input.form = form;
    settings.seed = variant.seed;
    settings.input.codes = moved_list(yard.targets, variant.motion);
    return segment_by_target_codes(cloud, settings, task);
  }();
  const std::vector<size_t> order = points_of(variant, yard.truth.size());
  const auto given = coded.cloud->fields.require("classification").values<uint8_t>();
  const auto labels = coded.labels->values<uint32_t>();
  Coded out{std::vector<uint8_t>(yard.truth.size(), kNoClass),
            std::vector<int64_t>(yard.truth.size(), 0),
            {},
            drawn_objects(model_coded_objects(coded, {}, task), variant.motion)};
  for (size_t k = 0; k < order.size(); ++k) {
    out.classes[order[k]] = given[k];
    if (labels[k] != 0) out.objects[order[k]] = coded.segments[labels[k] - 1].source_label;
  }
  for (const CodeWarning& w : read_coded_notes(coded.notes_json).warnings)
    out.warned.push_back(std::to_string(w.line) + " " + w.object);
  return out;
}

}  // namespace jalon::test
