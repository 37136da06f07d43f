// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "base/params.h"
#include "cloud/cloud.h"

namespace jalon {

/// How a class field agrees with a reference class field.
struct Confusion {
  std::vector<int64_t>
      classes;  ///< ascending: all values that either field has among the points counted
  std::vector<uint64_t> counts;  ///< [reference * classes + predicted]
  uint64_t points = 0;

  size_t size() const { return classes.size(); }
  uint64_t count(size_t reference, size_t predicted) const {
    return counts[reference * size() + predicted];
  }
};

/// The parameters of operation "confusion".
struct ConfusionSettings {
  std::vector<double> ignored_classes;  ///< of the reference
};
std::span<const ParamRow> confusion_rows();
Confusion confusion_of(const Cloud& cloud, std::string_view predicted, std::string_view reference,
                       const ConfusionSettings& settings, Task& task);

/// The tables of jalon/evaluate.h.
FieldTable class_table(const Confusion& confusion);
FieldTable agreement_table(const Confusion& confusion);

}  // namespace jalon
