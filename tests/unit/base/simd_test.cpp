// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/simd.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <string>

using namespace jalon;

TEST_CASE("use_avx2__needs_the_processor_and_no_wish_for_the_baseline") {
  const char* wish = std::getenv("JALON_SIMD");
  const bool baseline = wish != nullptr && std::string(wish) == "baseline";
  if (baseline) CHECK_FALSE(use_avx2());
#if defined(__x86_64__) && defined(__linux__)
  bool has = false;  // as the kernel lists it, not as the compiler asks
  std::ifstream info("/proc/cpuinfo");
  for (std::string word; info >> word;) has |= word == "avx2";
  if (info.eof()) CHECK(use_avx2() == (has && !baseline));
#endif
}

TEST_CASE("use_avx2__is_decided_once_whatever_the_environment_becomes") {
  const bool before = use_avx2();
  const char* wish = std::getenv("JALON_SIMD");
  const std::string kept = wish != nullptr ? wish : "";
  setenv("JALON_SIMD", before ? "baseline" : "", 1);
  CHECK(use_avx2() == before);
  if (wish != nullptr) setenv("JALON_SIMD", kept.c_str(), 1);
  else unsetenv("JALON_SIMD");
}
