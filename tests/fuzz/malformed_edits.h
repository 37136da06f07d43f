// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <string>

namespace malformed {

/// Overwrites bytes where they are there.
template <class T>
void put(std::string& bytes, size_t at, T value) {
  if (at + sizeof value <= bytes.size())
    std::memcpy(bytes.data() + at, &value, sizeof value);  // little-endian machines only
}

inline std::string repeated(const std::string& text, size_t times) {
  std::string out;
  for (size_t i = 0; i < times; ++i) out += text;
  return out;
}

/// The first occurrence, if there is one.
inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const size_t at = text.find(what);
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

}  // namespace malformed
