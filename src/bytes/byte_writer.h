// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "bytes/envelope.h"
#include "bytes/members.h"

namespace jalon {

static_assert(std::endian::native == std::endian::little,
              "values are written as they lie in memory, which must be little-endian");

/// Collects what an object is written as: small values are copied, large blocks are looked at again by sealed(), so
/// the object must live until then.
class ByteWriter {
 public:
  /// A number, an enum, a bool (a byte), a text (uint64 length, UTF-8), an array, or a struct that has members().
  template <class T>
  void item(const T& value) {
    if constexpr (kIsFlat<T> || std::is_enum_v<T>) {
      copy(&value, sizeof value);
    } else if constexpr (std::is_same_v<T, bool>) {
      item(static_cast<uint8_t>(value));
    } else if constexpr (kIsText<T>) {
      text(static_cast<const std::string&>(value));
    } else {
      std::apply([&](const auto&... member) { (item(member), ...); }, members(value));
    }
  }
  /// uint64 count, then the items.
  template <class T>
  void list(const std::vector<T>& items) {
    item(static_cast<uint64_t>(items.size()));
    if constexpr (kIsFlat<T>) {
      block(items.data(), items.size() * sizeof(T));
    } else {
      for (const T& each : items) item(each);
    }
  }
  void text(std::string_view text);
  void block(const void* data, size_t bytes);

  /// Header and payload.
  Buffer<uint8_t> sealed(BytesKind kind, Task& task) const;

 private:
  /// A block that stands behind the first bytes of small_.
  struct Block {
    const void* data;
    size_t bytes;
    size_t behind;
  };
  void copy(const void* data, size_t bytes);

  std::string small_;
  std::vector<Block> blocks_;
};

}  // namespace jalon
