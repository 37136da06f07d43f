// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace jalon::cli {

/// A small text file whole; an error is a Failure.
std::string read_text_file(const std::string& path);
/// Writes a small text file whole; an error is a Failure.
void write_text_file(const std::string& path, const std::string& text);
/// The numbers at the beginning of a text from end on, with blanks, commas or semicolons between; end becomes the place
/// of what is no number, or the size.
std::vector<double> leading_numbers(const std::string& text, size_t& end);

struct NumberLine {
  size_t line = 0;  ///< in the file, from 1
  std::vector<double> numbers;
};

/// The lines of numbers of a small text file. Empty lines, what follows a #, and headings before the first number are
/// left out; a word or a number that is not finite is a Failure that tells the line.
std::vector<NumberLine> read_number_lines(const std::string& path);

}  // namespace jalon::cli
