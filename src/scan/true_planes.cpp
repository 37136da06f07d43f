// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "scan/scan_output.h"
#include "scan/scanner.h"
#include "scan/truth.h"

namespace jalon {

FieldTable true_planes(const Model& model, const Cloud* cloud, double truth_min_area_m2,
                       std::span<const double> offset_m, Task& task) {
  validate(model);
  const Vec3 offset = offset_of(offset_m);
  const Truth truth = find_truth(model, truth_min_area_m2, task);
  std::span<const uint32_t> labels;
  if (cloud != nullptr) {
    const Column& segment = cloud->fields.require("segment");
    if (segment.info().type != ElementType::kUint32 || segment.info().components != 1)
      fail(Status::kInvalidArgument, "the field \"segment\" is not one uint32 a point");
    labels = segment.values<uint32_t>();
  }
  return truth_table(truth, offset, labels, task);
}

}  // namespace jalon
