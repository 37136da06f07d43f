// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "base/text_number.h"

namespace jalon {

/// A number as a table tells it; "-" where it is unknown.
inline std::string told_number(double value, int decimals = 3) {
  return std::isfinite(value) ? text_of(value, decimals) : "-";
}
/// A length in millimetres, to the hundredth.
inline std::string told_mm(double metres) { return told_number(1000 * metres, 2); }

}  // namespace jalon
