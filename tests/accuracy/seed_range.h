// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>

namespace jalon::test {

struct SeedRange {
  uint64_t first = 1, last = 1;
};

/// "7-12" or "7" of an environment variable.
inline std::optional<SeedRange> seeds_asked_for(const char* variable = "JALON_GRAMMAR_SEEDS") {
  const char* text = std::getenv(variable);
  if (text == nullptr) return {};
  char* end = nullptr;
  const uint64_t first = std::strtoull(text, &end, 10);
  return SeedRange{first, *end == '-' ? std::strtoull(end + 1, nullptr, 10) : first};
}

}  // namespace jalon::test
