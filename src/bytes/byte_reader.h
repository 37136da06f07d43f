// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/printf_format.h"
#include "base/task.h"
#include "bytes/envelope.h"
#include "bytes/members.h"

namespace jalon {

/// Takes an object's payload apart, front to back, and believes nothing: a count is held against what is left before
/// memory is asked for. What is wrong is Error(kFormat) with the byte where it stands.
class ByteReader {
 public:
  /// Of an object's bytes, header included, which must live as long as this.
  ByteReader(std::span<const uint8_t> whole, BytesKind kind, Task& task)
      : what_(name_of(kind)), payload_(payload_of(whole, kind, task)), left_(payload_) {}

  /// As ByteWriter::item wrote it.
  template <class T>
  void item(T& out) {
    if constexpr (kIsFlat<T> || std::is_enum_v<T>) {
      std::memcpy(&out, block(sizeof out), sizeof out);
    } else if constexpr (std::is_same_v<T, bool>) {
      const auto byte = take<uint8_t>();
      if (byte > 1) refuse("%u is neither 0 nor 1", byte);
      out = byte == 1;
    } else if constexpr (kIsText<T>) {
      out = text();
    } else {
      std::apply([&](auto&... member) { (item(member), ...); }, members(out));
    }
  }
  template <class T>
  T take() {
    T out{};
    item(out);
    return out;
  }
  template <class T>
  void list(std::vector<T>& out) {
    out.resize(count(least_bytes<T>()));
    if constexpr (kIsFlat<T>) {
      if (!out.empty())
        std::memcpy(out.data(), block(out.size() * sizeof(T)), out.size() * sizeof(T));
    } else {
      for (T& each : out) item(each);
    }
  }
  /// Valid UTF-8 without a 0.
  std::string text();
  /// So many bytes, which are there.
  const uint8_t* block(uint64_t bytes);
  /// A count of items of at least so many bytes each, which what is left can hold.
  size_t count(size_t item_bytes);
  /// Whether anything is left: what a later release wrote behind the rest.
  bool has_more() const { return !left_.empty(); }
  /// Nothing may be left.
  void end() const;

  [[noreturn]] void refuse(const char* format, ...) const JALON_PRINTF(2, 3);

 private:
  const char* what_;
  std::span<const uint8_t> payload_, left_;
};

}  // namespace jalon
