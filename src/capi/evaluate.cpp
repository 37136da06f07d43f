// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/evaluate.h"

#include "capi/support/evaluation_handles.h"
#include "capi/support/guard.h"
#include "capi/support/worker_handles.h"
#include "segment/evaluation/confusion.h"
#include "segment/evaluation/evaluation.h"
#include "segment/labels/from_labels.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

// A table of an evaluation as a new handle.
void give_table(const jalon_evaluation* evaluation, jalon_fields** out,
                FieldTable (*table)(const Evaluation&)) {
  require(evaluation, "evaluation");
  require(out, "out");
  *out = new_fields(table(evaluation->evaluation));
}

}  // namespace

jalon_status jalon_segmentation_from_labels(const jalon_cloud* cloud, const char* label_field,
                                            const jalon_params* options, jalon_task* task,
                                            jalon_segmentation** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const std::string field = require_text(label_field, "label_field");
    const auto set = settings_from<LabelSettings>(options_or_default(options, "labels"));
    auto handle = std::make_unique<jalon_segmentation>();
    with_task(task, [&](Task& t) {
      handle->segmentation = std::make_shared<const Segmentation>(
          segmentation_from_labels(cloud->cloud, field, set, t));
    });
    *out = handle.release();
  });
}

jalon_status jalon_segmentation_evaluate(const jalon_segmentation* automatic,
                                         const jalon_segmentation* reference,
                                         const jalon_params* options, jalon_task* task,
                                         jalon_evaluation** out) {
  return guard([&] {
    require(automatic, "automatic");
    require(reference, "reference");
    require(out, "out");
    const auto set = settings_from<EvaluationSettings>(options_or_default(options, "evaluation"));
    auto handle = std::make_unique<jalon_evaluation>();
    with_task(task, [&](Task& t) {
      handle->evaluation =
          evaluate_segmentation(*automatic->segmentation, *reference->segmentation, set, t);
    });
    *out = handle.release();
  });
}

jalon_evaluation* jalon_evaluation_retain(jalon_evaluation* evaluation) {
  return retain(evaluation);
}
void jalon_evaluation_release(jalon_evaluation* evaluation) { release(evaluation); }

jalon_status jalon_evaluation_pairs(const jalon_evaluation* evaluation, jalon_fields** out) {
  return guard([&] { give_table(evaluation, out, pair_table); });
}

jalon_status jalon_evaluation_automatic(const jalon_evaluation* evaluation, jalon_fields** out) {
  return guard([&] { give_table(evaluation, out, automatic_table); });
}

jalon_status jalon_evaluation_reference(const jalon_evaluation* evaluation, jalon_fields** out) {
  return guard([&] { give_table(evaluation, out, reference_table); });
}

jalon_status jalon_evaluation_totals(const jalon_evaluation* evaluation, jalon_fields** out) {
  return guard([&] { give_table(evaluation, out, totals_table); });
}

jalon_status jalon_cloud_confusion(const jalon_cloud* cloud, const char* class_field,
                                   const char* reference_field, const jalon_params* options,
                                   jalon_task* task, jalon_fields** classes,
                                   jalon_fields** totals) {
  return guard([&] {
    require(cloud, "cloud");
    const std::string found = require_text(class_field, "class_field"),
                      truth = require_text(reference_field, "reference_field");
    const auto set = settings_from<ConfusionSettings>(options_or_default(options, "confusion"));
    Owned<jalon_fields> rows = own<jalon_fields>(nullptr), sums = own<jalon_fields>(nullptr);
    with_task(task, [&](Task& t) {
      const Confusion confusion = confusion_of(*cloud->cloud, found, truth, set, t);
      if (classes != nullptr) rows = own(new_fields(class_table(confusion)));
      if (totals != nullptr) sums = own(new_fields(agreement_table(confusion)));
    });
    if (classes != nullptr) *classes = rows.release();
    if (totals != nullptr) *totals = sums.release();
  });
}
