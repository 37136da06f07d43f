// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cstdint>
#include <string_view>

namespace jalon {

/// A number of a text file and what kind it is.
struct ParsedNumber {
  double value = 0;
  bool integer = false;                                 ///< written without point or exponent
  bool wide = false;                                    ///< an integer that a double may not hold
  bool beyond_signed = false, beyond_unsigned = false;  ///< of a wide one: what 64 bits cannot hold
};

namespace fast_number_detail {
constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr uint64_t kExactInteger = uint64_t{1} << 53;
}  // namespace fast_number_detail

/// The number at the start of [at, end); returns where it ends, or nullptr when there is none.
/// Correctly rounded: a mantissa below 2^53 and a power of ten up to 22 are both exact doubles, so
/// one operation rounds once (Clinger 1990); all else goes to std::from_chars.
inline const char* parse_number_at(const char* at, const char* end, ParsedNumber& out) {
  using namespace fast_number_detail;
  const char* p = at;
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  const char* const first_digit = p;
  uint64_t mantissa = 0;
  for (; p != end && static_cast<unsigned>(*p - '0') < 10; ++p)
    mantissa = mantissa * 10 + static_cast<unsigned>(*p - '0');
  int64_t digits = p - first_digit;
  int64_t decimals = 0;
  const bool point = p != end && *p == '.';
  if (point) {
    const char* const fraction = ++p;
    for (; p != end && static_cast<unsigned>(*p - '0') < 10; ++p)
      mantissa = mantissa * 10 + static_cast<unsigned>(*p - '0');
    decimals = p - fraction;
    digits += decimals;
  }
  const bool exponent = p != end && (*p == 'e' || *p == 'E');
  if (digits != 0 && digits <= 19 && !exponent && mantissa <= kExactInteger && decimals <= 22) {
    const double value = static_cast<double>(mantissa) / kPowersOfTen[decimals];
    out = {negative ? -value : value, !point, false, false, false};
    return p;
  }
  const auto [stop, error] = std::from_chars(at != end && *at == '+' ? at + 1 : at, end, out.value);
  out.integer = digits != 0 && !point && !exponent;
  out.wide = out.integer;
  if (out.wide) {
    int64_t as_signed = 0;
    uint64_t as_unsigned = 0;
    const char* const from = at != end && *at == '+' ? at + 1 : at;
    out.beyond_signed = std::from_chars(from, end, as_signed).ec != std::errc();
    out.beyond_unsigned = negative || std::from_chars(from, end, as_unsigned).ec != std::errc();
  }
  return error == std::errc() ? stop : nullptr;
}

}  // namespace jalon
