// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/params.h"
#include "cloud/cloud.h"

namespace jalon {

struct FieldArithmeticSettings {
  enum class Operation {
    kAdd,
    kSubtract,
    kMultiply,
    kDivide,
    kMinimum,
    kMaximum,
    kPower,
    kAbsolute,
    kNegate,
    kSqrt,
    kSquare,
    kExp,
    kLog,
    kLog10,
    kDot,
    kNorm
  } operation = Operation::kAdd;
  double constant = 0;
  std::string name = "computed";
  std::string unit{};
};
std::span<const ParamRow> field_arithmetic_rows();

/// The cloud with the field a (operation) b, point by point; b empty: the option "constant". See jalon/field_tools.h.
Cloud with_computed_field(const Cloud& cloud, std::string_view a, std::string_view b,
                          const FieldArithmeticSettings& settings, Task& task);

}  // namespace jalon
