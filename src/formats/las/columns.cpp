// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Which field of a cloud goes where in a LAS point record.
#include <cmath>
#include <limits>
#include <set>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/files/endian.h"
#include "formats/files/normal_columns.h"
#include "formats/files/utf8.h"
#include "formats/las/plan.h"

namespace jalon::las {

namespace {

constexpr size_t kColumnsGrain = size_t{1} << 18;  // items a chunk when values are only looked at
constexpr size_t kMaxPlainBytes = 255;             // of a dimension of type 0

// Counts what does not fit, so that the answer is the same for any number of threads.
template <class F>
bool all_items(Task& task, size_t n, F&& fits) {
  return parallel_reduce<uint64_t>(task, n, kColumnsGrain, 0, [&](size_t begin, size_t end) {
           uint64_t bad = 0;
           for (size_t i = begin; i < end; ++i) bad += fits(i) ? 0 : 1;
           return bad;
         }) == 0;
}

// Integers that a place of their own kind holds whatever they are.
bool holds_all(const Place& place, ElementType type) {
  return place.bits == 0 && place.factor == 1 && place.type == type;
}

// Every value is a multiple of the place's factor that its integer can hold; when it rounds, near one.
bool fits(const Column& column, const Place& place, bool rounds, Task& task) {
  if (column.info().components != 1) return false;
  const ElementType type = column.info().type;
  if (is_floating(place.type)) {
    const bool exact = is_floating(type) ? size_of(type) <= size_of(place.type)
                                         : size_of(type) < size_of(place.type);
    return exact;
  }
  if (holds_all(place, type)) return true;
  return visit(place.type, [&](auto stored_zero) {
    using Stored = decltype(stored_zero);
    const double low =
        place.bits != 0 ? 0 : static_cast<double>(std::numeric_limits<Stored>::lowest());
    const double high = place.bits != 0 ? std::ldexp(1, place.bits) - 1
                                        : static_cast<double>(std::numeric_limits<Stored>::max());
    return visit(type, [&](auto zero) {
      using T = decltype(zero);
      const auto values = column.values<T>();
      if (std::is_integral_v<T> && place.factor == 1)
        return all_items(task, values.size(), [&](size_t i) {
          const double value = static_cast<double>(values[i]);
          return value >= low && value <= high;
        });
      return all_items(task, values.size(), [&](size_t i) {
        const double value = static_cast<double>(values[i]);
        const double rounded = std::nearbyint(value / place.factor);
        // Angles come back as float32.
        const bool same =
            place.factor == 1 || !std::is_same_v<T, float>
                ? rounded * place.factor == value
                : static_cast<float>(rounded * place.factor) == static_cast<float>(value);
        return (same || rounds) && rounded >= low && rounded <= high &&
               !(std::signbit(value) && value == 0);
      });
    });
  });
}

// The values are what the known dimension's raw integers give back.
bool fits_scaled(const Column& column, const ExtraDimension& known, Task& task) {
  return visit(known.raw_type, [&](auto raw_zero) {
    using Raw = decltype(raw_zero);
    if constexpr (std::is_floating_point_v<Raw>) {
      return false;
    } else {
      const auto values = column.values<double>();
      const size_t components = column.info().components;
      return all_items(task, values.size(), [&](size_t i) {
        const size_t c = i % components;
        const double raw = std::nearbyint((values[i] - known.shift[c]) / known.scale[c]);
        if (!(raw >= static_cast<double>(std::numeric_limits<Raw>::lowest()) &&
              raw < std::ldexp(1, std::numeric_limits<Raw>::digits)))
          return false;
        return static_cast<double>(static_cast<Raw>(raw)) * known.scale[c] + known.shift[c] ==
               values[i];
      });
    }
  });
}

std::string free_name(std::string_view wanted, std::set<std::string>& taken) {
  std::string name(utf8_prefix(wanted, 32));
  for (size_t number = 2; !taken.insert(name).second; ++number) {
    const std::string tail = std::to_string(number);
    name = utf8_prefix(wanted, 31 - tail.size());
    name.append("_").append(tail);
  }
  return name;
}

class Layout {
 public:
  explicit Layout(unsigned format) : format_(format), at_(point_format(format)->bytes) {}

  void add_known(const ColumnPtr& column, const ExtraDimension& known) {
    ExtraColumn extra = plain(column, 0, column->info().components);
    extra.scaled = known.scaled;
    extra.raw_type = known.raw_type;
    std::copy_n(known.scale, 3, extra.scale.begin());
    std::copy_n(known.shift, 3, extra.shift.begin());
    extra.descriptor = known.descriptor;
    for (size_t d = 0; d + kDescriptorBytes <= known.descriptor.size(); d += kDescriptorBytes)
      taken_.insert(text_field(known.descriptor.data() + d + 4, 32));
    push(std::move(extra));
  }

  void add_new(const ColumnPtr& column) {
    const FieldInfo& field = column->info();
    FieldInfo one = field;
    one.components = 1;
    if (is_normal(field)) {
      ExtraColumn extra = plain(column, 0, 3);
      for (const char* name : kNormalNames)
        append(extra.descriptor, descriptor_of(one, free_name(name, taken_)));
      push(std::move(extra));
    } else if (field.components <= 3) {
      ExtraColumn extra = plain(column, 0, field.components);
      extra.descriptor = descriptor_of(field, free_name(own_name(field.name), taken_));
      push(std::move(extra));
    } else if (field.type == ElementType::kUint8 && field.components <= kMaxPlainBytes) {
      ExtraColumn extra = plain(column, 0, field.components);
      extra.descriptor = descriptor_of(one, free_name(own_name(field.name), taken_));
      extra.descriptor[2] = std::byte{0};
      extra.descriptor[3] = static_cast<std::byte>(field.components);
      push(std::move(extra));
    } else {
      for (uint32_t c = 0; c < field.components; ++c) {
        ExtraColumn extra = plain(column, c, 1);
        extra.descriptor = descriptor_of(one, free_name(numbered(field.name, c), taken_));
        push(std::move(extra));
      }
    }
  }

  void add_undescribed(const ColumnPtr& column) {
    push(plain(column, 0, column->info().components));
  }

  bool is_standard(const std::string& field) const {
    for (const Dimension& dimension : dimensions(format_))
      if (dimension.field.name == field) return true;
    return false;
  }

  std::vector<ExtraColumn> take() { return std::move(columns_); }

 private:
  static ExtraColumn plain(const ColumnPtr& column, uint32_t component, uint32_t components) {
    ExtraColumn extra;
    extra.column = column;
    extra.component = component;
    extra.components = components;
    extra.raw_type = column->info().type;
    return extra;
  }
  static void append(std::vector<std::byte>& to, const std::vector<std::byte>& from) {
    to.insert(to.end(), from.begin(), from.end());
  }
  void push(ExtraColumn extra) {
    extra.offset = at_;
    at_ += size_of(extra.raw_type) * extra.components;
    if (at_ > std::numeric_limits<uint16_t>::max())
      fail(Status::kLimit, "the fields take more than the 65535 bytes a LAS point may have");
    columns_.push_back(std::move(extra));
  }

  // No name of a standard dimension: other programs take each name once.
  std::string own_name(const std::string& field) const {
    return is_standard(field) ? exact_name(field) : field;
  }

  unsigned format_;
  size_t at_;
  std::vector<ExtraColumn> columns_;
  std::set<std::string> taken_;
};

}  // namespace

std::vector<StandardColumn> standard_columns(const FieldTable& fields, unsigned format,
                                             std::vector<ColumnPtr>& left, Task& task) {
  std::vector<StandardColumn> out;
  const std::vector<Dimension> all = dimensions(format);
  for (const ColumnPtr& column : fields) {
    const Dimension* found = nullptr;
    for (const Dimension& dimension : all)
      if (dimension.field.name == column->info().name) found = &dimension;
    const auto is_held = [&](bool rounds) { return fits(*column, found->place, rounds, task); };
    const bool is_exact = found != nullptr && is_held(false);
    if (is_exact || (found != nullptr && found->place.factor != 1 && is_held(true)))
      out.push_back({column, found->place});
    if (!is_exact) left.push_back(column);
  }
  return out;
}

std::vector<ExtraColumn> extra_columns(const std::vector<ColumnPtr>& fields,
                                       const std::vector<ExtraDimension>& known, unsigned format,
                                       Task& task) {
  Layout layout(format);
  std::set<const Column*> done;
  for (const ExtraDimension& dimension : known)
    for (const ColumnPtr& column : fields) {
      const FieldInfo& field = column->info();
      if (dimension.descriptor.empty() || layout.is_standard(field.name) ||
          field.name != dimension.field.name || field.type != dimension.field.type ||
          field.components != dimension.field.components ||
          (dimension.scaled && !fits_scaled(*column, dimension, task)))
        continue;
      layout.add_known(column, dimension);
      done.insert(column.get());
    }
  ColumnPtr undescribed;
  for (const ColumnPtr& column : fields) {
    if (done.contains(column.get())) continue;
    if (column->info().name == "extra_bytes" && column->info().type == ElementType::kUint8)
      undescribed = column;
    else layout.add_new(column);
  }
  if (undescribed) layout.add_undescribed(undescribed);
  return layout.take();
}

}  // namespace jalon::las
