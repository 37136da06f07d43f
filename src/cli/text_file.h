// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace jalon::cli {

/// A small text file whole; an error is a Failure.
std::string read_text_file(const std::string& path);
/// Writes a small text file whole; an error is a Failure.
void write_text_file(const std::string& path, const std::string& text);
/// The numbers of a line, up to a #; blanks, commas or semicolons between. None where something else stands in it.
std::vector<double> numbers_of(std::string line);

}  // namespace jalon::cli
