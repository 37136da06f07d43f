// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace jalon {

constexpr std::string_view kReplacementCharacter = "\xEF\xBF\xBD";  // U+FFFD

/// The text with every byte that is no valid UTF-8, and every NUL, replaced by U+FFFD.
std::string valid_utf8(std::string_view text);
/// The longest start of a valid text that has at most this many bytes and ends with a whole
/// character.
std::string_view utf8_prefix(std::string_view text, size_t bytes);
/// A text field of fixed width in a binary file: ends at the first NUL, trailing blanks off, made
/// valid, control characters to blanks.
std::string text_field(const void* data, size_t bytes);
/// A field's name from a file: valid, no control characters, at most 256 bytes, not empty (fallback
/// then).
std::string name_from_file(std::string_view text, std::string_view fallback);
/// "name_2": a name told apart from others by a number.
std::string numbered(std::string_view name, size_t number);
/// Gives every name once: "a", "a_2", "a_3" ... Cost O(log n) a name, also when all are equal.
class UniqueNames {
 public:
  std::string add(const std::string& name);

 private:
  std::map<std::string, size_t> next_;  ///< of each name given: the number to try next
};
/// ASCII lower case.
std::string lower(std::string_view text);

}  // namespace jalon
