// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jalon {

/// The numbers of jalon/types.h.
enum class ElementType : int32_t {
  kInt8 = 1,
  kUint8 = 2,
  kInt16 = 3,
  kUint16 = 4,
  kInt32 = 5,
  kUint32 = 6,
  kInt64 = 7,
  kUint64 = 8,
  kFloat32 = 9,
  kFloat64 = 10,
};

bool is_element_type(int32_t type);
size_t size_of(ElementType type);
bool is_floating(ElementType type);
const char* name_of(ElementType type);  ///< "int8" ... "float64"

template <class T>
constexpr ElementType element_type_of() {
  if constexpr (std::is_floating_point_v<T>)
    return sizeof(T) == 4 ? ElementType::kFloat32 : ElementType::kFloat64;
  else
    return static_cast<ElementType>(std::countr_zero(sizeof(T)) * 2 +
                                    (std::is_signed_v<T> ? 1 : 2));
}

/// Calls f with a value-initialised element of the type: visit(type, [&](auto zero) { using T = decltype(zero); ... }).
template <class F>
decltype(auto) visit(ElementType type, F&& f) {
  switch (type) {
    case ElementType::kInt8:
      return f(int8_t{});
    case ElementType::kUint8:
      return f(uint8_t{});
    case ElementType::kInt16:
      return f(int16_t{});
    case ElementType::kUint16:
      return f(uint16_t{});
    case ElementType::kInt32:
      return f(int32_t{});
    case ElementType::kUint32:
      return f(uint32_t{});
    case ElementType::kInt64:
      return f(int64_t{});
    case ElementType::kUint64:
      return f(uint64_t{});
    case ElementType::kFloat32:
      return f(float{});
    case ElementType::kFloat64:
      break;
  }
  return f(double{});
}

/// What a column is called and means; meta data travels with it to files and bindings.
struct FieldInfo {
  std::string name;
  ElementType type = ElementType::kFloat64;
  uint32_t components = 1;
  std::string unit = {};
  std::string meaning = {};
};

constexpr uint32_t kMostComponents = 4096;  ///< of a column that comes from outside

/// One named column: count items of components elements, packed, written once and then shared read-only
/// through shared_ptr<const Column>. New elements are uninitialised.
class Column {
 public:
  Column(FieldInfo info, size_t count);
  const FieldInfo& info() const { return info_; }
  size_t count() const { return count_; }
  size_t bytes() const { return count_ * info_.components * size_of(info_.type); }
  void* raw() { return data_.get(); }
  const void* raw() const { return data_.get(); }
  /// The elements as T; T must be the column's type (checked).
  template <class T>
  std::span<T> values() {
    check(element_type_of<T>());
    return {static_cast<T*>(raw()), count_ * info_.components};
  }
  template <class T>
  std::span<const T> values() const {
    check(element_type_of<T>());
    return {static_cast<const T*>(raw()), count_ * info_.components};
  }
  /// Element (item, component) converted to double; for tables and text, not for loops over millions.
  double number(size_t item, uint32_t component = 0) const;

 private:
  void check(ElementType type) const;
  struct Free {
    void operator()(void* p) const;
  };
  FieldInfo info_;
  size_t count_;
  std::unique_ptr<void, Free> data_;
};

using ColumnPtr = std::shared_ptr<const Column>;

/// Named columns of equal length. Copying it shares the columns.
class FieldTable {
 public:
  size_t size() const { return columns_.size(); }
  const ColumnPtr& at(size_t i) const { return columns_[i]; }
  /// nullptr when there is none.
  const Column* find(std::string_view name) const;
  ColumnPtr find_shared(std::string_view name) const;
  /// Error(kNotFound) that lists the names there are.
  const Column& require(std::string_view name) const;
  void set(ColumnPtr column);  ///< adds, or replaces the one of that name in its place
  /// Adds one whose name is new, which the caller has seen to: O(1), where set() looks at all names.
  void add(ColumnPtr column) { columns_.push_back(std::move(column)); }
  bool remove(std::string_view name);
  auto begin() const { return columns_.begin(); }
  auto end() const { return columns_.end(); }

 private:
  std::vector<ColumnPtr> columns_;
};

/// A column filled from values; convenience for small tables.
template <class T>
ColumnPtr make_column(FieldInfo info, std::span<const T> values) {
  info.type = element_type_of<T>();
  auto column =
      std::make_shared<Column>(info, values.size() / (info.components ? info.components : 1));
  auto out = column->template values<T>();
  for (size_t i = 0; i < out.size(); ++i) out[i] = values[i];
  return column;
}

/// The rows of these indices, as a new column.
ColumnPtr gather(const Column& column, std::span<const uint64_t> indices);
/// Copies count items from strided memory of another type into items [first, first + count) of the column, converting.
/// A value that the column's integers cannot hold is Error(kInvalidArgument) naming the item.
void store_converted(Column& column, size_t first, const void* data, ElementType type, size_t count,
                     size_t stride_bytes);
/// The same outwards: all elements, packed, to the type given.
void load_converted(const Column& column, ElementType type, void* out);

}  // namespace jalon
