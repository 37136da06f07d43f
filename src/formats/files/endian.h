// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>

namespace jalon {

template <class T>
T byte_swapped(T value) {
  auto bytes = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
  std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

/// Unaligned loads and stores in a given byte order.
template <class T, std::endian Order = std::endian::little>
T load(const void* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return Order == std::endian::native ? value : byte_swapped(value);
}
template <class T, std::endian Order = std::endian::little>
void store(void* to, T value) {
  if (Order != std::endian::native) value = byte_swapped(value);
  std::memcpy(to, &value, sizeof value);
}
/// Stores the value behind what is there.
template <std::endian Order = std::endian::little, class T>
void append_stored(std::string& out, T value) {
  char bytes[sizeof value];
  store<T, Order>(bytes, value);
  out.append(bytes, sizeof bytes);
}

}  // namespace jalon
