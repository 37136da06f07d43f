// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstring>
#include <limits>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "base/large_memory.h"

namespace jalon {

/// Memory for vector loops, uninitialised, in large pages where it is large: of small ones each costs a fault, and a
/// cancelled call 70 ms a gigabyte to give them back. std::bad_alloc where there is none. By the operators of C++,
/// since Windows has no aligned_alloc.
inline void* allocate_aligned(size_t bytes) {
  void* memory = ::operator new (bytes, std::align_val_t{64});
  if (bytes >= kLargeBytes) advise_large_pages(memory, bytes);
  return memory;
}
inline void free_aligned(void* memory) { ::operator delete (memory, std::align_val_t{64}); }

/// Fixed-length array of plain values, left uninitialised: for large buffers that are written whole before
/// they are read. 64-byte aligned, with at least 64 zero bytes behind the end so that vector loops may over-read.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  explicit Buffer(size_t size) : size_(size) {
    if (size > (std::numeric_limits<size_t>::max() / 2) / sizeof(T)) throw std::bad_alloc();
    if (size == 0) return;
    const size_t bytes = (size * sizeof(T) + 64 + 63) / 64 * 64;
    data_ = static_cast<T*>(allocate_aligned(bytes));
    std::memset(reinterpret_cast<char*>(data_) + size * sizeof(T), 0, bytes - size * sizeof(T));
  }
  Buffer(Buffer&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  Buffer& operator=(Buffer&& other) noexcept {
    if (this != &other) {
      free_aligned(data_);
      data_ = std::exchange(other.data_, nullptr);
      size_ = std::exchange(other.size_, 0);
    }
    return *this;
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() { free_aligned(data_); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](size_t i) { return data_[i]; }
  const T& operator[](size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }

 private:
  T* data_ = nullptr;
  size_t size_ = 0;
};

}  // namespace jalon
