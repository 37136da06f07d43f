// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/simd.h"

#include <cstdlib>
#include <cstring>

namespace jalon {

bool use_avx2() {
#if defined(__x86_64__)
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
