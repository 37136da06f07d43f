// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "scan/scanner.h"
#include "scan/truth.h"

namespace jalon {

std::span<const ScannerMethod> scanner_methods() {
  static constexpr ScannerMethod kMethods[] = {
      {"static", "scanner static", static_scanner_rows, scan_static},
      {"sample", "scanner sample", sample_scanner_rows, scan_sample},
  };
  return kMethods;
}

FieldTable true_planes(const Model& model, const Cloud* cloud, const ParamSet& params, Task& task) {
  validate(model);
  const auto& offset = params.numbers("offset_m");
  if (offset.size() != 3) fail(Status::kInvalidArgument, "offset_m takes three numbers");
  const Truth truth = find_truth(model, params.number("truth_min_area_m2"), task);
  std::span<const uint32_t> labels;
  if (cloud != nullptr) {
    const Column& segment = cloud->fields.require("segment");
    if (segment.info().type != ElementType::kUint32 || segment.info().components != 1)
      fail(Status::kInvalidArgument, "the field \"segment\" is not one uint32 a point");
    labels = segment.values<uint32_t>();
  }
  return truth_table(truth, {offset[0], offset[1], offset[2]}, labels, task);
}

}  // namespace jalon
