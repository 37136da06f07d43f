// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/e57/columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/parallel.h"
#include "formats/e57/normals.h"
#include "formats/files/normal_columns.h"
#include "formats/files/utf8.h"

namespace jalon::e57 {

namespace {

constexpr size_t kMostColumns = 200;      // of fields: our reader takes 256 in all
constexpr double kLargestWhole = 0x1p53;  // of the numbers that a double tells apart
constexpr size_t kRangeGrain = size_t{1} << 17;

/// What the values of a field are between, and whether all are numbers.
struct Range {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
  bool has_none = false;
  Range& operator+=(const Range& b) {
    min = std::min(min, b.min);
    max = std::max(max, b.max);
    has_none = has_none || b.has_none;
    return *this;
  }
  bool within(double least, double most) const { return !(min < least) && !(max > most); }
};

Range range_of(const Column& column, Task& task) {
  const size_t components = column.info().components;
  return parallel_reduce<Range>(task, column.count(), kRangeGrain, {},
                                [&](size_t begin, size_t end) {
                                  return visit(column.info().type, [&](auto zero) {
                                    using T = decltype(zero);
                                    const T* values = static_cast<const T*>(column.raw());
                                    Range range;
                                    for (size_t i = begin * components; i < end * components; ++i) {
                                      const auto value = static_cast<double>(values[i]);
                                      if (std::isnan(value)) range.has_none = true;
                                      else range += {value, value};
                                    }
                                    return range;
                                  });
                                });
}

/// The kind that gives the type back when it is read.
JcColumn kind_of(ElementType type) {
  JcColumn out{"", kJcDouble, 0, 0, 1, 0};
  if (type == ElementType::kFloat32) out.kind = kJcSingle;
  if (is_floating(type)) return out;
  out.kind = kJcInteger;
  visit(type, [&](auto zero) {
    using Limits = std::numeric_limits<decltype(zero)>;
    out.min = std::max(-kLargestWhole, static_cast<double>(Limits::lowest()));
    out.max = std::min(kLargestWhole, static_cast<double>(Limits::max()));
  });
  return out;
}

class Planner {
 public:
  Planner(const Cloud& cloud, Task& task) : cloud_(cloud), task_(task) {}

  Columns run() {
    add_standard();
    for (const ColumnPtr& column : cloud_.fields)
      if (done_.count(column.get()) == 0) add_own(*column);
    return std::move(out_);
  }

 private:
  const Column* scalar(const char* name) const {
    const Column* column = cloud_.fields.find(name);
    return column != nullptr && column->info().components == 1 ? column : nullptr;
  }

  OutColumn& add(const std::string& name, JcColumn column, const Column& field,
                 uint32_t component = 0) {
    out_.names.push_back(name);
    column.name = out_.names.back().c_str();
    out_.fields.push_back({column, &field, component});
    done_.insert(&field);
    return out_.fields.back();
  }

  void add_validity(const char* name, const Column& field) {
    JcColumn flag = kind_of(ElementType::kUint8);
    flag.max = 1;
    add(name, flag, field).is_validity = true;
  }

  void add_standard() {
    if (const Column* intensity = scalar("intensity")) {
      add("intensity", kind_of(intensity->info().type), *intensity);
      if (range_of(*intensity, task_).has_none) add_validity("isIntensityInvalid", *intensity);
    }
    add_colours();
    for (const auto& [name, column] : {std::pair{"row", "rowIndex"}, {"column", "columnIndex"}})
      add_index(name, column);
    add_returns();
    const Column* time = scalar("time");
    if (time != nullptr && is_floating(time->info().type)) {
      const Range range = range_of(*time, task_);
      if (range.min >= 0 && std::isfinite(range.max)) {
        add("timeStamp", kind_of(time->info().type), *time);
        if (range.has_none) add_validity("isTimeStampInvalid", *time);
      }
    }
    for (const ColumnPtr& column : cloud_.fields)
      if (is_normal(column->info()) && is_floating(column->info().type))
        for (uint32_t k = 0; k < 3; ++k)
          add(std::string("nor:") + kNormalParts[k], kind_of(ElementType::kFloat32), *column, k)
              .is_normal = true;
  }

  // All three, of one type without sign.
  void add_colours() {
    static constexpr std::pair<const char*, const char*> kColours[] = {
        {"red", "colorRed"}, {"green", "colorGreen"}, {"blue", "colorBlue"}};
    for (const auto& [name, column] : kColours) {
      const Column* field = scalar(name);
      if (field == nullptr || field->info().type != cloud_.fields.find("red")->info().type ||
          (field->info().type != ElementType::kUint8 && field->info().type != ElementType::kUint16))
        return;
    }
    for (const auto& [name, column] : kColours) {
      const Column& field = *cloud_.fields.find(name);
      add(column, kind_of(field.info().type), field);
    }
  }

  // As few bits as the largest wants.
  void add_index(const char* name, const char* column, double shift = 0) {
    const Column* field = scalar(name);
    if (field == nullptr || is_floating(field->info().type)) return;
    const Range range = range_of(*field, task_);
    if (!range.within(-shift, std::numeric_limits<uint32_t>::max())) return;
    JcColumn kind = kind_of(ElementType::kUint32);
    kind.max = std::max(1.0, range.max + shift);
    add(column, kind, *field).shift = shift;
  }

  // Both or none (ASTM E2807); the first return is number 0.
  void add_returns() {
    const Column *number = scalar("return_number"), *count = scalar("number_of_returns");
    if (number == nullptr || count == nullptr) return;
    for (const Column* field : {number, count})
      if (is_floating(field->info().type)) return;
    if (!range_of(*number, task_).within(1, 255) || !range_of(*count, task_).within(0, 255)) return;
    add_index("return_number", "returnIndex", -1);
    add_index("number_of_returns", "returnCount");
  }

  void add_own(const Column& field) {
    const FieldInfo& info = field.info();
    const bool wide = info.type == ElementType::kInt64 || info.type == ElementType::kUint64;
    const char* reason = nullptr;
    if (out_.fields.size() + info.components > kMostColumns) reason = "too many columns";
    else if (wide && !range_of(field, task_).within(-kLargestWhole, kLargestWhole))
      reason = "integers beyond 2^53";
    if (reason != nullptr) {
      task_.log(Task::kWarning, "E57: the field \"%s\" is left out: %s", info.name.c_str(), reason);
      return;
    }
    for (uint32_t c = 0; c < info.components; ++c)
      add("jalon:" + own_name(info.components == 1 ? info.name : numbered(info.name, c + 1)),
          kind_of(info.type), field, c);
  }

  // XML's names: letters, digits, "_" and "-", no digit first, not "xml".
  std::string own_name(const std::string& name) {
    std::string out;
    for (const char c : name) {
      const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                         (c >= '0' && c <= '9') || c == '_' || c == '-';
      out += plain ? c : '_';
    }
    const char first = out.empty() ? '-' : out[0];
    if (first == '-' || (first >= '0' && first <= '9') || lower(out).starts_with("xml"))
      out.insert(0, "_");
    return unique_.add(out);
  }

  const Cloud& cloud_;
  Task& task_;
  Columns out_;
  std::set<const Column*> done_;
  UniqueNames unique_;
};

}  // namespace

Columns columns_of(const Cloud& cloud, Task& task) { return Planner(cloud, task).run(); }

}  // namespace jalon::e57
