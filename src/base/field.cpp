// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/field.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include "base/buffer.h"
#include "base/error.h"

namespace jalon {

bool is_element_type(int32_t type) { return type >= 1 && type <= 10; }

size_t size_of(ElementType type) {
  return visit(type, [](auto zero) { return sizeof zero; });
}

bool is_floating(ElementType type) {
  return type == ElementType::kFloat32 || type == ElementType::kFloat64;
}

const char* name_of(ElementType type) {
  static constexpr const char* kNames[] = {"",       "int8",    "uint8",  "int16",
                                           "uint16", "int32",   "uint32", "int64",
                                           "uint64", "float32", "float64"};
  return kNames[static_cast<int32_t>(type)];
}

void Column::Free::operator()(void* p) const { free_aligned(p); }

Column::Column(FieldInfo info, size_t count) : info_(std::move(info)), count_(count) {
  const size_t item = size_of(info_.type) * info_.components;
  if (item != 0 && count > (std::numeric_limits<size_t>::max() / 2) / item) throw std::bad_alloc();
  if (item * count == 0) return;
  // 64 readable bytes behind the end, as in Buffer.
  data_.reset(allocate_aligned((item * count + 64 + 63) / 64 * 64));
}

void Column::check(ElementType type) const {
  if (type != info_.type)
    fail(Status::kInternal, "field \"%s\" holds %s, read as %s", info_.name.c_str(),
         name_of(info_.type), name_of(type));
}

double Column::number(size_t item, uint32_t component) const {
  return visit(info_.type, [&](auto zero) {
    using T = decltype(zero);
    return static_cast<double>(static_cast<const T*>(raw())[item * info_.components + component]);
  });
}

const Column* FieldTable::find(std::string_view name) const {
  for (const auto& column : columns_)
    if (column->info().name == name) return column.get();
  return nullptr;
}

ColumnPtr FieldTable::find_shared(std::string_view name) const {
  for (const auto& column : columns_)
    if (column->info().name == name) return column;
  return nullptr;
}

const Column& FieldTable::require(std::string_view name) const {
  if (const Column* column = find(name)) return *column;
  std::string names;
  for (const auto& column : columns_) names += (names.empty() ? "" : ", ") + column->info().name;
  fail(Status::kNotFound, "no field \"%.*s\"; there are: %s", static_cast<int>(name.size()),
       name.data(), names.empty() ? "none" : names.c_str());
}

void FieldTable::set(ColumnPtr column) {
  for (auto& old : columns_)
    if (old->info().name == column->info().name) {
      old = std::move(column);
      return;
    }
  columns_.push_back(std::move(column));
}

bool FieldTable::remove(std::string_view name) {
  for (size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i]->info().name == name) {
      columns_.erase(columns_.begin() + static_cast<ptrdiff_t>(i));
      return true;
    }
  return false;
}

ColumnPtr gather(const Column& column, std::span<const uint64_t> indices) {
  auto out = std::make_shared<Column>(column.info(), indices.size());
  const size_t item = size_of(column.info().type) * column.info().components;
  const auto* from = static_cast<const char*>(column.raw());
  auto* to = static_cast<char*>(out->raw());
  const auto copy = [&](auto size) {
    for (size_t i = 0; i < indices.size(); ++i)
      std::memcpy(to + i * size, from + indices[i] * size, size);
  };
  switch (item) {  // constant sizes become plain moves
    case 1:
      copy(std::integral_constant<size_t, 1>{});
      break;
    case 2:
      copy(std::integral_constant<size_t, 2>{});
      break;
    case 4:
      copy(std::integral_constant<size_t, 4>{});
      break;
    case 8:
      copy(std::integral_constant<size_t, 8>{});
      break;
    case 12:
      copy(std::integral_constant<size_t, 12>{});
      break;
    case 24:
      copy(std::integral_constant<size_t, 24>{});
      break;
    default:
      copy(item);
  }
  return out;
}

namespace {

template <class To, class From>
bool convert(From value, To& out) {
  if constexpr (std::is_same_v<To, From> || std::is_floating_point_v<To>) {
    out = static_cast<To>(value);
    return true;
  } else if constexpr (std::is_floating_point_v<From>) {
    // The limits of 64-bit integers are no doubles; the half-open comparison is exact.
    const double low = static_cast<double>(std::numeric_limits<To>::lowest());
    const double high = std::ldexp(1.0, std::numeric_limits<To>::digits);
    const double rounded = std::nearbyint(static_cast<double>(value));
    if (!(rounded >= low && rounded < high)) return false;
    out = static_cast<To>(rounded);
    return true;
  } else {
    if (!std::in_range<To>(value)) return false;
    out = static_cast<To>(value);
    return true;
  }
}

}  // namespace

void store_converted(Column& column, size_t first, const void* data, ElementType type, size_t count,
                     size_t stride_bytes) {
  const uint32_t components = column.info().components;
  visit(column.info().type, [&](auto to_zero) {
    using To = decltype(to_zero);
    To* out = static_cast<To*>(column.raw()) + first * components;
    visit(type, [&](auto from_zero) {
      using From = decltype(from_zero);
      for (size_t i = 0; i < count; ++i) {
        const char* item = static_cast<const char*>(data) + i * stride_bytes;
        for (uint32_t c = 0; c < components; ++c) {
          From value;
          std::memcpy(&value, item + c * sizeof value, sizeof value);
          if (!convert(value, *out++))
            fail(Status::kInvalidArgument, "item %llu of field \"%s\" does not fit %s",
                 static_cast<unsigned long long>(first + i), column.info().name.c_str(),
                 name_of(column.info().type));
        }
      }
    });
  });
}

void load_converted(const Column& column, ElementType type, void* out) {
  const size_t n = column.count() * column.info().components;
  visit(column.info().type, [&](auto from_zero) {
    using From = decltype(from_zero);
    const From* from = static_cast<const From*>(column.raw());
    visit(type, [&](auto to_zero) {
      using To = decltype(to_zero);
      if constexpr (std::is_same_v<To, From>) {
        if (n != 0) std::memcpy(out, from, n * sizeof(To));
      } else {
        To value{};
        for (size_t i = 0; i < n; ++i)
          if (!convert(from[i], value))
            fail(Status::kInvalidArgument, "element %llu of field \"%s\" does not fit %s",
                 static_cast<unsigned long long>(i), column.info().name.c_str(), name_of(type));
        for (size_t i = 0; i < n; ++i) {
          convert(from[i], value);
          std::memcpy(static_cast<char*>(out) + i * sizeof value, &value, sizeof value);
        }
      }
    });
  });
}

}  // namespace jalon
