// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/simd.h"

#include <cstdlib>
#include <cstring>

namespace jalon {

bool use_avx2() {
// GCC for Windows keeps stacks aligned to 16 bytes and takes them for aligned to 32 (its bug 54412).
#if defined(__x86_64__) && !(defined(__MINGW32__) && !defined(__clang__))
  static const bool use = [] {
    const char* wish = std::getenv("JALON_SIMD");
    return __builtin_cpu_supports("avx2") &&
           !(wish != nullptr && std::strcmp(wish, "baseline") == 0);
  }();
  return use;
#else
  return false;
#endif
}

}  // namespace jalon
