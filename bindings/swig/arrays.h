/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Arrays that cross the border of a language, in both directions. */
#ifndef JALON_BINDINGS_ARRAYS_H
#define JALON_BINDINGS_ARRAYS_H

#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <vector>

#include "handles.h"

namespace jalon_binding {

inline std::uint64_t size_of_type(std::int32_t type) {
  static const std::uint64_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return type >= JALON_INT8 && type <= JALON_FLOAT64 ? sizes[type] : 0;
}

/**
 * An array of the language, borrowed for one call: count items of components elements, side by side; stride_bytes from
 * one item to the next. flat: numbers without rows, so (x, y, z, x, ...) may stand for rows of three.
 */
struct ArrayIn {
  const void* data = nullptr;
  std::int32_t type = JALON_FLOAT64;
  std::uint64_t count = 0;
  std::uint32_t components = 1;
  std::uint64_t stride_bytes = 0;
  bool flat = false;

  ArrayIn() = default;
  ArrayIn(const void* data_, std::int32_t type_, std::uint64_t count_)
      : data(data_), type(type_), count(count_), stride_bytes(size_of_type(type_)), flat(true) {}
};

/** The array as rows of so many elements; says what was expected where it is none. nullptr: no array was given. */
inline ArrayIn rows_of(const ArrayIn* array, std::uint32_t components, const char* name) {
  if (array == nullptr) return ArrayIn();
  ArrayIn rows = *array;
  const bool packed = rows.stride_bytes == size_of_type(rows.type) * rows.components;
  if (rows.components != components && packed && rows.flat) {
    const std::uint64_t elements = rows.count * rows.components;
    if (elements % components == 0) {
      rows.count = elements / components;
      rows.components = components;
      rows.stride_bytes = size_of_type(rows.type) * components;
    }
  }
  if (rows.components != components && rows.count != 0) {
    const std::string found = rows.flat ? std::to_string(rows.count) + " numbers"
                                        : "rows of " + std::to_string(rows.components);
    throw Failure{JALON_ERROR_INVALID_ARGUMENT, std::string(name) + " must have rows of " +
                                                    std::to_string(components) + ", not " + found};
  }
  static const double nothing = 0;  // so that an empty array is not taken for none
  if (rows.data == nullptr) rows.data = &nothing;
  return rows;
}

template <class T>
struct TypeOf;
template <>
struct TypeOf<double> {
  static constexpr std::int32_t value = JALON_FLOAT64;
};
template <>
struct TypeOf<float> {
  static constexpr std::int32_t value = JALON_FLOAT32;
};
template <>
struct TypeOf<std::uint64_t> {
  static constexpr std::int32_t value = JALON_UINT64;
};
template <>
struct TypeOf<std::uint32_t> {
  static constexpr std::int32_t value = JALON_UINT32;
};

/** For indices of which none at all stand for all points: an array without any is no choice of points. */
inline void refuse_none(const ArrayIn* array, const char* name) {
  if (array != nullptr && array->count * array->components == 0) {
    throw Failure{JALON_ERROR_INSUFFICIENT_DATA,
                  std::string(name) + " means no point: where all points are meant, leave it out"};
  }
}

/**
 * A packed array of T that a C function asks for: the caller's own memory where it is that already, else one converted
 * copy. A value that T cannot hold is refused.
 */
template <class T>
class Packed {
 public:
  Packed(const ArrayIn* array, std::uint32_t components, const char* name)
      : given_(array != nullptr), name_(name) {
    const ArrayIn rows = rows_of(array, components, name);
    count_ = rows.count;
    if (!given_) return;
    const bool same = rows.type == TypeOf<T>::value;
    if (same && (rows.count < 2 || rows.stride_bytes == sizeof(T) * components) &&
        reinterpret_cast<std::uintptr_t>(rows.data) % alignof(T) == 0) {
      data_ = static_cast<const T*>(rows.data);
      return;
    }
    copy_.resize(static_cast<std::size_t>(rows.count * components) + 1);
    convert(rows, components);
    data_ = copy_.data();
  }
  const T* data() const { return data_; }
  std::uint64_t count() const { return count_; }
  bool given() const { return given_; }
  /** Of arrays that stand side by side: the same number of items as the first, unless there is none. */
  const T* data_like(std::uint64_t count) const {
    if (given_ && count_ != count) {
      throw Failure{JALON_ERROR_INVALID_ARGUMENT, std::string(name_) + " has " +
                                                      std::to_string(count_) + " items where " +
                                                      std::to_string(count) + " are needed"};
    }
    return data_;
  }

 private:
  void convert(const ArrayIn& rows, std::uint32_t components) {
    T* to = copy_.data();
    for (std::uint64_t i = 0; i < rows.count; ++i) {
      const char* item = static_cast<const char*>(rows.data) + i * rows.stride_bytes;
      for (std::uint32_t c = 0; c < components; ++c) *to++ = element(item, rows.type, c);
    }
  }
  T element(const char* item, std::int32_t type, std::uint32_t c) const {
    switch (type) {
      case JALON_INT8:
        return as<std::int8_t>(item, c);
      case JALON_UINT8:
        return as<std::uint8_t>(item, c);
      case JALON_INT16:
        return as<std::int16_t>(item, c);
      case JALON_UINT16:
        return as<std::uint16_t>(item, c);
      case JALON_INT32:
        return as<std::int32_t>(item, c);
      case JALON_UINT32:
        return as<std::uint32_t>(item, c);
      case JALON_INT64:
        return as<std::int64_t>(item, c);
      case JALON_UINT64:
        return as<std::uint64_t>(item, c);
      case JALON_FLOAT32:
        return as<float>(item, c);
      default:
        return as<double>(item, c);
    }
  }
  template <class From>
  T as(const char* item, std::uint32_t c) const {
    From value;
    std::memcpy(&value, item + c * sizeof(From), sizeof(From));
    if (std::numeric_limits<T>::is_integer && !whole(value)) {
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    std::string(name_) + " must hold whole numbers from 0 to 2^" +
                        std::to_string(std::numeric_limits<T>::digits) + " - 1" +
                        (std::numeric_limits<From>::is_integer ? ", not " + std::to_string(value)
                                                               : std::string())};
    }
    return static_cast<T>(value);
  }
  template <class From>
  static bool whole(From value) {
    if (!std::numeric_limits<From>::is_integer) {
      const double wide = static_cast<double>(value);
      return wide >= 0 && wide < 18446744073709551616.0 &&
             wide <= static_cast<double>(std::numeric_limits<T>::max()) &&
             wide == static_cast<double>(static_cast<std::uint64_t>(wide));
    }
    return value >= From(0) && static_cast<std::uint64_t>(value) <=
                                   static_cast<std::uint64_t>(std::numeric_limits<T>::max());
  }

  bool given_;
  const char* name_;
  const T* data_ = nullptr;
  std::uint64_t count_ = 0;
  std::vector<T> copy_;
};

/** An array on its way to the language: a view with whatever keeps it alive. The C side's memory is never copied here.
 */
class Array {
 public:
  Array(const jalon_array_view& view, std::shared_ptr<void> owner)
      : view_(view), owner_(std::move(owner)) {}
  template <class T>
  static Array* made(std::uint64_t rows, std::uint64_t columns, T** data) {
    if (columns != 0 && rows > (std::uint64_t(1) << 46) / columns) {
      throw Failure{JALON_ERROR_LIMIT, "the result would have more than 2^46 elements"};
    }
    const std::uint64_t bytes = rows * columns * sizeof(T);
    std::shared_ptr<void> owner(std::malloc(bytes == 0 ? 1 : bytes), std::free);
    if (owner == nullptr) throw std::bad_alloc();
    *data = static_cast<T*>(owner.get());
    const jalon_array_view view = {owner.get(), rows, static_cast<std::uint32_t>(columns),
                                   TypeOf<T>::value, columns * sizeof(T)};
    return new Array(view, std::move(owner));
  }
  /** Memory for elements of a type known at run time. */
  static Array* made_as(std::int32_t type, std::uint64_t rows, std::uint32_t columns) {
    const std::uint64_t size = size_of_type(type);
    if (size == 0)
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    "there is no element type " + std::to_string(type)};
    std::shared_ptr<void> owner(std::malloc(rows * columns * size + 1), std::free);
    if (owner == nullptr) throw std::bad_alloc();
    const jalon_array_view view = {owner.get(), rows, columns, type, columns * size};
    return new Array(view, std::move(owner));
  }
  /** Small results: points, boxes, transforms, covariances. */
  static Array* of(const double* values, std::uint64_t rows, std::uint64_t columns) {
    double* data = nullptr;
    Array* array = made<double>(rows, columns, &data);
    if (rows * columns > 0) std::memcpy(data, values, rows * columns * sizeof(double));
    return array;
  }

  const void* data() const { return view_.data; }
  std::uint64_t count() const { return view_.count; }
  std::uint32_t components() const { return view_.components; }
  std::int32_t type() const { return view_.type; }
  std::uint64_t stride_bytes() const { return view_.stride_bytes; }
  const std::shared_ptr<void>& owner() const { return owner_; }

 private:
  jalon_array_view view_;
  std::shared_ptr<void> owner_;
};

/** Small arrays of doubles, which languages hand out as their own arrays. */
typedef Array Numbers;
/** An object's bytes, which languages hand out as their own bytes. */
typedef Array Octets;

/** Bytes of the language, borrowed for one call. */
class OctetsIn {
 public:
  OctetsIn(const ArrayIn* array, const char* name) {
    if (array == nullptr) return;
    const bool is_packed = array->components <= 1 && (array->count < 2 || array->stride_bytes == 1);
    if (size_of_type(array->type) != 1 || !is_packed)
      throw Failure{JALON_ERROR_INVALID_ARGUMENT,
                    std::string(name) + " must be bytes side by side"};
    static const std::uint8_t nothing = 0;  // so that no bytes are not taken for none given
    data_ = array->data == nullptr ? &nothing : static_cast<const std::uint8_t*>(array->data);
    count_ = array->count;
  }
  const std::uint8_t* data() const { return data_; }
  std::uint64_t count() const { return count_; }

 private:
  const std::uint8_t* data_ = nullptr;
  std::uint64_t count_ = 0;
};

/** The view of an array that this handle owns. */
template <class H>
Array* view_of(const jalon_array_view& view, H* owner) {
  ++live_handles();
  return new Array(view, std::shared_ptr<void>(Ownership<H>::retain(owner), [](void* handle) {
                     Ownership<H>::release(static_cast<H*>(handle));
                     --live_handles();
                   }));
}

}  // namespace jalon_binding

#endif
