// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/large_memory.h"

#include <cstdint>
#include <cstring>

#if defined(__linux__)
#include <sys/mman.h>
#endif
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace jalon {

void advise_large_pages(void* memory, size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  // The whole pages in it: what lies around them may be another's.
  constexpr uintptr_t kLargePage = uintptr_t{2} << 20;
  const auto address = reinterpret_cast<uintptr_t>(memory);
  const uintptr_t begin = (address + kLargePage - 1) / kLargePage * kLargePage;
  const uintptr_t end = (address + bytes) / kLargePage * kLargePage;
  if (end > begin) (void)madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#else
  (void)memory;
  (void)bytes;
#endif
}

namespace {

// IEEE 754 binary64: without its sign, one step of the exponent added, the sign bit is set where the exponent was all
// ones, which means infinite or not a number.
constexpr uint64_t kWithoutSign = 0x7fffffffffffffff;
constexpr uint64_t kExponentStep = 0x0010000000000000;

bool copy_some(const char* from, size_t begin, size_t n, double* to) {
  uint64_t overflow = 0;
  for (size_t i = begin; i < n; ++i) {
    uint64_t bits;
    std::memcpy(&bits, from + i * sizeof bits, sizeof bits);
    overflow |= (bits & kWithoutSign) + kExponentStep;
    std::memcpy(to + i, &bits, sizeof bits);
  }
  return overflow >> 63 == 0;
}

}  // namespace

bool copy_finite(const void* from, size_t n, double* to) {
  const auto* bytes = static_cast<const char*>(from);
#if defined(__SSE2__)
  const __m128i without_sign = _mm_set1_epi64x(static_cast<int64_t>(kWithoutSign));
  const __m128i step = _mm_set1_epi64x(static_cast<int64_t>(kExponentStep));
  __m128i overflow = _mm_setzero_si128();
  const size_t even = n / 2 * 2;
  for (size_t i = 0; i < even; i += 2) {
    const __m128i pair =
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes + i * sizeof(double)));
    overflow = _mm_or_si128(overflow, _mm_add_epi64(_mm_and_si128(pair, without_sign), step));
    _mm_stream_si128(reinterpret_cast<__m128i*>(to + i), pair);
  }
  _mm_sfence();
  const bool finite = _mm_movemask_pd(_mm_castsi128_pd(overflow)) == 0;
  return copy_some(bytes, even, n, to) && finite;
#else
  return copy_some(bytes, 0, n, to);
#endif
}

}  // namespace jalon
