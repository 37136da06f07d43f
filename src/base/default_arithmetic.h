// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__SSE__) || defined(_M_X64)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace jalon {

/// While it lives this thread computes as C does by default: to the nearest, with gradual underflow, without traps. A
/// host may have set otherwise (fast mathematics flush to zero in a whole thread, some runtimes trap): the same input
/// has the same bits there too, and what the host had set comes back. Threads that start meanwhile begin with the
/// default.
class DefaultArithmetic {
 public:
#if defined(__SSE__) || defined(_M_X64)
  DefaultArithmetic() noexcept : host_(_mm_getcsr()) {
    if ((host_ & kControl) != kDefault) _mm_setcsr(kDefault);
  }
  ~DefaultArithmetic() {
    if ((host_ & kControl) != kDefault) _mm_setcsr(host_);
  }

 private:
  // Intel SDM, volume 1, 10.2.3: below are the sticky flags; all exceptions masked, rounding to the nearest.
  static constexpr unsigned kControl = 0xFFC0, kDefault = 0x1F80;
  unsigned host_;
#else
  DefaultArithmetic() noexcept : host_(std::fegetround()) {
    if (host_ != FE_TONEAREST) std::fesetround(FE_TONEAREST);
  }
  ~DefaultArithmetic() {
    if (host_ != FE_TONEAREST) std::fesetround(host_);
  }

 private:
  int host_;
#endif

 public:
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;
};

}  // namespace jalon
