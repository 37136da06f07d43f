// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/text_file.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "cli/handles.h"

namespace jalon::cli {

std::string read_text_file(const std::string& path) {
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

std::vector<double> numbers_of(std::string line) {
  line.resize(std::min(line.size(), line.find('#')));
  std::vector<double> out;
  const char *at = line.data(), *end = at + line.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == '\t' || *at == ',' || *at == ';' || *at == '\r'))
      ++at;
    if (at == end) return out;
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc()) return {};
    out.push_back(value);
    at = next;
  }
}

}  // namespace jalon::cli
