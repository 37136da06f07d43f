// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/field_arithmetic.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "fieldtools/field_values.h"

namespace jalon {

namespace {

using Operation = FieldArithmeticSettings::Operation;

constexpr size_t kFieldArithmeticGrain = 1 << 15;

constexpr ParamRow kOperationRow = choice_row<&FieldArithmeticSettings::operation>(
    "operation",
    "add|subtract|multiply|divide|minimum|maximum|power|absolute|negate|sqrt|square|exp|log|log10|"
    "dot|norm",
    "",
    "a + b and so on; the ones from absolute to log10 and norm read a alone; dot: the scalar "
    "product of two fields, summed over their components; norm: the length of a's items");

struct Operator {
  Operation operation;
  double (*f)(double a, double b);
};
constexpr Operator kOperators[] = {
    {Operation::kAdd, [](double a, double b) { return a + b; }},
    {Operation::kSubtract, [](double a, double b) { return a - b; }},
    {Operation::kMultiply, [](double a, double b) { return a * b; }},
    {Operation::kDivide, [](double a, double b) { return b != 0 ? a / b : kNaN; }},
    {Operation::kMinimum, [](double a, double b) { return a < b   ? a
                                                          : b < a ? b
                                                                  : a + 0 * b; }},
    {Operation::kMaximum, [](double a, double b) { return a > b   ? a
                                                          : b > a ? b
                                                                  : a + 0 * b; }},
    {Operation::kPower, [](double a, double b) { return std::pow(a, b); }},
    {Operation::kAbsolute, [](double a, double) { return std::fabs(a); }},
    {Operation::kNegate, [](double a, double) { return -a; }},
    {Operation::kSqrt, [](double a, double) { return a >= 0 ? std::sqrt(a) : kNaN; }},
    {Operation::kSquare, [](double a, double) { return a * a; }},
    {Operation::kExp, [](double a, double) { return std::exp(a); }},
    {Operation::kLog, [](double a, double) { return a > 0 ? std::log(a) : kNaN; }},
    {Operation::kLog10, [](double a, double) { return a > 0 ? std::log10(a) : kNaN; }},
    {Operation::kDot, [](double a, double b) { return a * b; }},
    {Operation::kNorm, [](double a, double) { return a * a; }},
};

/// All elements of a column as doubles.
std::vector<double> elements(const Column& column) {
  std::vector<double> out(column.count() * column.info().components);
  load_converted(column, ElementType::kFloat64, out.data());
  return out;
}

}  // namespace

std::span<const ParamRow> field_arithmetic_rows() {
  using S = FieldArithmeticSettings;
  static constexpr auto kRows =
      setting_rows(kOperationRow,
                   number_row<&S::constant>("constant", -1e300, 1e300, "", "",
                                            "Stands for b where no second field is named"),
                   string_row<&S::name>("name", "", "Name of the new field; it may be that of a"),
                   string_row<&S::unit>("unit", "", "Unit of the new field"));
  return kRows;
}

Cloud with_computed_field(const Cloud& cloud, std::string_view a, std::string_view b,
                          const FieldArithmeticSettings& settings, Task& task) {
  const std::string name = require_field_name(settings.name);
  const Operation operation = settings.operation;
  const Column& first = cloud.fields.require(a);
  const Column* second = b.empty() ? nullptr : &cloud.fields.require(b);
  const uint32_t components = first.info().components;
  if (second != nullptr && second->info().components != components &&
      second->info().components != 1)
    fail(Status::kInvalidArgument, "the fields have %u and %u components", components,
         second->info().components);
  const Operator* op = kOperators;
  while (operation != op->operation) ++op;
  const std::vector<double> left = elements(first);
  const std::vector<double> right = second != nullptr ? elements(*second) : std::vector<double>();
  const uint32_t right_components = second != nullptr ? second->info().components : 1;
  const double constant = settings.constant;
  const bool summed = operation == Operation::kDot || operation == Operation::kNorm;
  std::vector<double> out(summed ? cloud.size() : left.size());
  parallel_for(task, cloud.size(), kFieldArithmeticGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      double sum = 0;
      for (uint32_t c = 0; c < components; ++c) {
        const size_t at = i * components + c;
        const double r =
            right.empty() ? constant : right[i * right_components + (right_components > 1 ? c : 0)];
        const double value = op->f(left[at], r);
        sum += value;
        if (!summed) out[at] = value;
      }
      if (summed) out[i] = operation == Operation::kNorm ? std::sqrt(sum) : sum;
    }
  });
  Cloud result = cloud;
  const std::string meaning = choice_at(kOperationRow, static_cast<size_t>(operation)) + " of " +
                              std::string(a) + (b.empty() ? "" : " and " + std::string(b));
  result.fields.set(make_column<double>(
      {name, ElementType::kFloat64, summed ? 1 : components, settings.unit, meaning}, out));
  return result;
}

}  // namespace jalon
