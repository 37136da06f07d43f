// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/units/length_units.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/text_number.h"
#include "formats/files/utf8.h"
#include "formats/units/crs_code.h"

namespace jalon {

namespace {

struct EpsgRun {
  uint32_t first, last, step;
  double metres;
};
constexpr EpsgRun kEpsgRuns[] = {
#include "formats/units/epsg_units.inc"
};

// The usual geographic 2D systems of the same dataset.
constexpr uint32_t kGeographic[][2] = {
    {4001, 4016}, {4018, 4025}, {4027, 4036}, {4041, 4047}, {4052, 4055}, {4120, 4176},
    {4178, 4185}, {4188, 4216}, {4218, 4289}, {4291, 4304}, {4306, 4319}, {4322, 4322},
    {4324, 4324}, {4326, 4326}, {4463, 4463}, {4470, 4470}, {4475, 4475}, {4483, 4483},
    {4490, 4490}, {4555, 4555}, {4558, 4558}, {4600, 4646}, {4657, 4765}, {4801, 4811},
    {4813, 4821}, {4823, 4824}, {4901, 4904}, {6318, 6318}, {6668, 6668}, {6706, 6706},
    {7844, 7844}};

constexpr size_t kMaxDepth = 64;  // of brackets; real WKT nests about 8 deep

bool is_word(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

// Reads WKT as nested KEYWORD[...] and notes the units that stand directly in a projected,
// vertical, local or geographic system.
class UnitFinder {
 public:
  explicit UnitFinder(std::string_view wkt) : text_(wkt) {}

  LengthUnits run() {
    for (size_t i = 0; i < text_.size(); ++i) {
      const char c = text_[i];
      if (c == '"') {
        i = text_.find('"', i + 1);
        if (i == std::string_view::npos) break;
      } else if (c == '[' || c == '(') {
        if (!enter(i)) break;
      } else if (c == ']' || c == ')') {
        if (!stack_.empty()) stack_.pop_back();
      }
    }
    if (horizontal_ == 0 && !degrees_ && is_projected()) ask_code();
    LengthUnits units;
    units.degrees = degrees_ && horizontal_ == 0;
    units.known = horizontal_ != 0 || degrees_;
    units.horizontal = horizontal_ != 0 ? horizontal_ : 1;
    units.vertical = vertical_ != 0 ? vertical_ : units.horizontal;
    return units;
  }

 private:
  bool enter(size_t bracket) {
    size_t end = bracket;
    while (end > 0 && text_[end - 1] == ' ') --end;
    size_t begin = end;
    while (begin > 0 && is_word(text_[begin - 1])) --begin;
    std::string word = lower(text_.substr(begin, std::min<size_t>(end - begin, 32)));
    if (stack_.size() == kMaxDepth) return false;
    if (word == "unit" || word == "lengthunit" || word == "angleunit") note(word, bracket + 1);
    stack_.push_back(std::move(word));
    return true;
  }

  void note(std::string_view keyword, size_t at) {
    size_t i = stack_.size();
    while (i > 0 && (stack_[i - 1] == "axis" || stack_[i - 1] == "cs")) --i;
    if (i == 0) return;
    const std::string& system = stack_[i - 1];
    const bool angle = keyword == "angleunit";
    if (system == "geogcs" || system == "geogcrs" || system == "geographiccrs" ||
        system == "geodcrs") {
      bool projected = false;
      for (const std::string& word : stack_) projected = projected || word.starts_with("proj");
      if (!projected && (keyword == "unit" || angle)) degrees_ = true;
      return;
    }
    const double metres = factor(at);
    if (angle || metres == 0) return;
    const bool local = system == "local_cs" || system == "engcrs" || system == "engineeringcrs";
    const bool plane =
        local || system == "projcs" || system == "projcrs" || system == "projectedcrs";
    if (plane && horizontal_ == 0) horizontal_ = metres;
    if ((system == "vert_cs" || system == "vertcrs" || system == "verticalcrs") && vertical_ == 0)
      vertical_ = metres;
  }

  bool is_projected() const {
    const size_t begin = std::min(text_.find_first_not_of(" \t\r\n"), text_.size());
    return lower(text_.substr(begin, 4)) == "proj";
  }

  // A system that names no unit has that of its code.
  void ask_code() {
    if (const uint32_t code = wkt_epsg_code(text_)) horizontal_ = unit_of_epsg(code);
  }

  // The number after the name: ["US survey foot", 0.3048006096...
  double factor(size_t at) const {
    const size_t open = text_.find('"', at);
    const size_t close = open == std::string_view::npos ? open : text_.find('"', open + 1);
    const size_t comma = close == std::string_view::npos ? close : text_.find(',', close);
    if (comma == std::string_view::npos) return 0;
    size_t begin = comma + 1;
    while (begin < text_.size() &&
           (text_[begin] == ' ' || text_[begin] == '\n' || text_[begin] == '\r'))
      ++begin;
    size_t end = begin;
    while (end < text_.size() &&
           (is_word(text_[end]) || text_[end] == '.' || text_[end] == '-' || text_[end] == '+'))
      ++end;
    double value = 0;
    if (!parse_number(text_.substr(begin, end - begin), value)) return 0;
    return std::isfinite(value) && value > 1e-6 && value < 1e6
               ? value
               : 0;  // beyond these it is no length of a map
  }

  std::string_view text_;
  std::vector<std::string> stack_;
  double horizontal_ = 0, vertical_ = 0;
  bool degrees_ = false;
};

}  // namespace

double unit_of_epsg(uint32_t code) {
  for (const EpsgRun& run : kEpsgRuns)
    if (code >= run.first && code <= run.last && (code - run.first) % run.step == 0)
      return run.metres;
  return 1;
}

uint32_t epsg_code(std::string_view crs) {
  if (crs.size() < 6 || lower(crs.substr(0, 5)) != "epsg:") return 0;
  uint32_t code = 0;
  const auto [end, error] = std::from_chars(crs.data() + 5, crs.data() + crs.size(), code);
  return error == std::errc() && end == crs.data() + crs.size() ? code : 0;
}

LengthUnits units_of_crs(std::string_view crs) {
  if (const uint32_t code = epsg_code(crs)) {
    LengthUnits units;
    units.known = true;
    units.horizontal = units.vertical = unit_of_epsg(code);
    for (const auto& [first, last] : kGeographic)
      units.degrees = units.degrees || (code >= first && code <= last);
    return units;
  }
  if (crs.find('[') == std::string_view::npos && crs.find('(') == std::string_view::npos) return {};
  return UnitFinder(crs).run();
}

}  // namespace jalon
