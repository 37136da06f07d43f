// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Vectors of 32-bit lanes in the width of the file's instruction set: 8 with AVX2, else 4. For kernels that are
// compiled once a set; everything is in an unnamed namespace, so that the linker cannot mix the two. Operations act
// lane by lane, in the same order for both widths, so both give the same bits.

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace jalon {
namespace {

#if defined(__AVX2__)
constexpr uint32_t kLanes = 8;
#else
constexpr uint32_t kLanes = 4;
#endif

using Ints = int32_t __attribute__((vector_size(4 * kLanes)));
using Words = uint32_t __attribute__((vector_size(4 * kLanes)));
using Floats = float __attribute__((vector_size(4 * kLanes)));

template <class V, class T>
[[gnu::always_inline]] inline V load(const T* p) {
  V v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
template <class V, class T>
[[gnu::always_inline]] inline void store(T* p, V v) {
  std::memcpy(p, &v, sizeof v);
}
template <class To, class From>
[[gnu::always_inline]] inline To as(From v) {
  To out;
  std::memcpy(&out, &v, sizeof out);
  return out;
}
[[gnu::always_inline]] inline Floats to_floats(Ints v) {
  return __builtin_convertvector(v, Floats);
}
[[gnu::always_inline]] inline Words smaller(Words a, Words b) { return a < b ? a : b; }
[[gnu::always_inline]] inline Words larger(Words a, Words b) { return a < b ? b : a; }

/// One bit a lane, from its highest bit.
[[gnu::always_inline]] inline uint32_t bits_of(Ints v) {
#if defined(__AVX2__)
  return static_cast<uint32_t>(_mm256_movemask_ps(as<__m256>(v)));
#elif defined(__SSE2__)
  return static_cast<uint32_t>(_mm_movemask_ps(as<__m128>(v)));
#else
  uint32_t bits = 0;
  for (uint32_t i = 0; i < kLanes; ++i) bits |= (static_cast<uint32_t>(v[i]) >> 31) << i;
  return bits;
#endif
}

/// Lane by lane: the index of the lane itself.
inline Ints lane_numbers() {
  Ints v{};
  for (uint32_t i = 0; i < kLanes; ++i) v[i] = static_cast<int32_t>(i);
  return v;
}

}  // namespace
}  // namespace jalon
