// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/inputs/targets_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cli/text_file.h"

namespace jalon::cli {

namespace {

constexpr const char* kForm = "a target is: name x y z [sigma | sx sy sz]";

std::vector<std::string> words_of(std::string line) {
  line.resize(std::min(line.size(), line.find('#')));
  std::vector<std::string> out;
  constexpr const char* kBetween = " \t,;\r";
  for (size_t at = line.find_first_not_of(kBetween); at != std::string::npos;) {
    const size_t end = std::min(line.find_first_of(kBetween, at), line.size());
    out.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBetween, end);
  }
  return out;
}

bool is_number(const std::string& word, double& out) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), out);
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(out);
}

[[noreturn]] void malformed(const std::string& path, size_t line, const std::string& why) {
  throw Failure{JALON_ERROR_FORMAT, path + ", line " + std::to_string(line) + ": " + why};
}

// Words of a line after its name, which three numbers alone do not have.
struct Line {
  std::string name;
  std::vector<double> numbers;
  std::string wrong;  ///< the first word that is no number
};

Line line_of(const std::vector<std::string>& words) {
  Line out;
  double value = 0;
  const bool bare = words.size() == 3 && is_number(words[0], value);
  if (!bare && words[0] != "-") out.name = words[0];
  for (size_t i = bare ? 0 : 1; i < words.size(); ++i) {
    if (is_number(words[i], value)) out.numbers.push_back(value);
    else if (out.wrong.empty()) out.wrong = words[i];
  }
  return out;
}

jalon_target target_of(const Line& line, const std::string& path, size_t at) {
  const std::vector<double>& n = line.numbers;
  if (!line.wrong.empty()) malformed(path, at, "\"" + line.wrong + "\" is no number; " + kForm);
  if (n.size() != 3 && n.size() != 4 && n.size() != 6)
    malformed(path, at, std::to_string(n.size()) + " numbers after the name; " + kForm);
  jalon_target out{};
  out.xyz = {n[0], n[1], n[2]};
  for (size_t k = 0; k < 3 && n.size() > 3; ++k) {
    const double sigma = n.size() == 4 ? n[3] : n[3 + k];
    if (!(sigma > 0)) malformed(path, at, "a standard deviation is not positive");
    out.covariance[4 * k] = sigma * sigma;
  }
  return out;
}

}  // namespace

Targets read_targets(const std::string& path) {
  std::string text = read_text_file(path);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  Targets out;
  size_t number = 0;
  bool first = true;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    const std::vector<std::string> words = words_of(text.substr(at, end - at));
    at = end + 1;
    ++number;
    if (words.empty()) continue;
    const Line line = line_of(words);
    const bool is_heading = first && line.numbers.empty();
    first = false;
    if (is_heading) continue;
    out.rows.push_back(target_of(line, path, number));
    out.names.push_back(line.name);
  }
  if (out.rows.empty()) throw Failure{JALON_ERROR_FORMAT, path + ": no target in it; " + kForm};
  for (size_t i = 0; i < out.rows.size(); ++i)
    out.rows[i].name = out.names[i].empty() ? nullptr : out.names[i].c_str();
  return out;
}

}  // namespace jalon::cli
