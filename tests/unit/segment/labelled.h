// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "base/error.h"
#include "segment/evaluation/evaluation.h"
#include "segment/labels/from_labels.h"

namespace jalon::test {

inline EvaluationSettings evaluation_params(const char* json = "{}") {
  ParamSet params("evaluation", evaluation_rows());
  params.from_json(json);
  return settings_from<EvaluationSettings>(params);
}

inline Segmentation from_labels(const CloudPtr& cloud, const char* field, const char* json = "{}",
                                unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  ParamSet params("labels", labels_rows());
  params.from_json(json);
  return segmentation_from_labels(cloud, field, settings_from<LabelSettings>(params), task);
}

/// A cloud with the fields "automatic" and "reference".
inline CloudPtr make_labelled_cloud(Buffer<double> xyz, const std::vector<int64_t>& automatic,
                                    const std::vector<int64_t>& reference) {
  Cloud cloud = make_cloud(std::move(xyz));
  cloud.fields.set(make_column<int64_t>({"automatic"}, automatic));
  cloud.fields.set(make_column<int64_t>({"reference"}, reference));
  return std::make_shared<const Cloud>(std::move(cloud));
}

inline Evaluation evaluate_labels(const CloudPtr& cloud, const char* json = "{}",
                                  unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return evaluate_segmentation(from_labels(cloud, "automatic", "{}", threads),
                               from_labels(cloud, "reference", "{}", threads),
                               evaluation_params(json), task);
}

/// Points that carry a label of each side; each reference label (or, without one, automatic label) lies on a plane of
/// its own.
struct Labelled {
  std::vector<int64_t> automatic, reference;

  void add(uint64_t count, int64_t a, int64_t r) {
    automatic.insert(automatic.end(), count, a);
    reference.insert(reference.end(), count, r);
  }
  CloudPtr cloud(double shift_m = 0) const {
    Buffer<double> xyz(3 * automatic.size());
    for (size_t i = 0; i < automatic.size(); ++i) {
      const int64_t plane = reference[i] != 0 ? reference[i] : automatic[i];
      xyz[3 * i] = 0.02 * static_cast<double>(i % 97) + shift_m;
      xyz[3 * i + 1] = static_cast<double>(plane);
      xyz[3 * i + 2] = 0.02 * static_cast<double>(i / 97 % 89);
    }
    return make_labelled_cloud(std::move(xyz), automatic, reference);
  }
  Evaluation evaluate(const char* json = "{}", unsigned threads = 2) const {
    return evaluate_labels(cloud(), json, threads);
  }
};

}  // namespace jalon::test
