// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/text_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cli/handles.h"

namespace jalon::cli {

namespace {

constexpr size_t kShownBytes = 40;  // of a wrong line, in its message

}  // namespace

std::string read_text_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw Failure{JALON_ERROR_NOT_FOUND, path + ": it is a folder, no file"};
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Failure{JALON_ERROR_NOT_FOUND, path + ": cannot be opened"};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_text_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.flush();
  if (!file) throw Failure{JALON_ERROR_IO, path + ": cannot be written"};
}

std::vector<double> leading_numbers(const std::string& text, size_t& end) {
  constexpr const char* kBetween = " \t,;\r";
  std::vector<double> out;
  while ((end = std::min(text.find_first_not_of(kBetween, end), text.size())) < text.size()) {
    double value = 0;
    const char* last = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + end, last, value);
    const size_t next = static_cast<size_t>(stop - text.data());
    const bool is_word = next < text.size() && std::strchr(kBetween, text[next]) == nullptr;
    if (error != std::errc() || is_word || !std::isfinite(value)) return out;
    out.push_back(value);
    end = next;
  }
  return out;
}

std::vector<NumberLine> read_number_lines(const std::string& path) {
  const std::string text = read_text_file(path);
  std::vector<NumberLine> out;
  size_t line = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t feed = std::min(text.find('\n', at), text.size());
    std::string row = text.substr(at, feed - at);
    row.resize(std::min(row.size(), row.find('#')));
    at = feed + 1;
    ++line;
    size_t end = 0;
    std::vector<double> numbers = leading_numbers(row, end);
    const bool is_heading = numbers.empty() && out.empty();
    if (end < row.size() && !is_heading)
      throw Failure{JALON_ERROR_FORMAT, path + ", line " + std::to_string(line) + ": \"" +
                                            row.substr(end, kShownBytes) + "\" is no number"};
    if (!numbers.empty()) out.push_back({line, std::move(numbers)});
  }
  return out;
}

}  // namespace jalon::cli
