// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace jalon {

/// Numbers from and to text without any locale (std::from_chars, std::to_chars).

/// The whole text as a double ("inf", "nan", a leading '+' allowed); false when it is none.
bool parse_number(std::string_view text, double& out);
bool parse_integer(std::string_view text, int64_t& out);
/// Shortest text that reads back to the same value.
std::string text_of(double value);
/// Fixed notation with this many decimals; "-0.00" becomes "0.00".
std::string text_of(double value, int decimals);

}  // namespace jalon
