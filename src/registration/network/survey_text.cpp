// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/survey_text.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <span>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

namespace {

using Cells = std::vector<std::string_view>;

constexpr double kHalfTurn_rad = std::numbers::pi;
constexpr int kQuoted = 40;  // bytes of a cell that a message repeats

Cells cells_in(std::string_view line, char separator) {
  Cells cells;
  const char* blanks = " \t\r";
  for (;;) {
    if (separator == ' ') line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    if (separator == ' ' && line.empty()) return cells;
    const size_t end = separator == ' ' ? line.find_first_of(blanks) : line.find(separator);
    std::string_view cell = line.substr(0, end);
    cell.remove_prefix(std::min(cell.find_first_not_of(blanks), cell.size()));
    cell = cell.substr(0, cell.find_last_not_of(blanks) + 1);
    cells.push_back(cell);
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

char separator_of(std::string_view line) {
  for (const char c : {';', '\t', ','})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

/// A list with named columns, line by line.
class NamedLines {
 public:
  NamedLines(const char* list, std::string_view text, std::span<const char* const> known)
      : list_(list), text_(text) {
    if (!advance()) return;
    separator_ = separator_of(line_);
    const Cells names = cells_in(line_, separator_);
    for (size_t i = 0; i < names.size(); ++i) {
      const bool is_known = std::find(known.begin(), known.end(), names[i]) != known.end();
      if (!is_known || !columns_.emplace(names[i], i).second)
        refuse(is_known ? "column named twice:" : "no column of this name:", names[i]);
    }
  }

  bool next() {
    if (!advance()) return false;
    cells_ = cells_in(line_, separator_);
    if (cells_.size() > columns_.size()) refuse("more cells than columns:", line_);
    return true;
  }
  size_t line() const { return number_; }

  /// "" where there is none.
  std::string_view text(const char* name) const {
    const auto column = columns_.find(std::string_view(name));
    if (column == columns_.end() || column->second >= cells_.size()) return {};
    const std::string_view cell = cells_[column->second];
    return cell == "-" ? std::string_view() : cell;
  }
  std::string_view needed(const char* name) const {
    const std::string_view cell = text(name);
    if (cell.empty()) refuse("nothing in column", name);
    return cell;
  }
  double number(const char* name, double otherwise, double least = -INFINITY) const {
    const std::string_view cell = text(name);
    if (cell.empty()) return otherwise;
    double value = 0;
    if (!parse_number(cell, value) || !std::isfinite(value)) refuse("no number:", cell);
    if (value < least) refuse("too small a number:", cell);
    return value;
  }
  [[noreturn]] void refuse(const char* what, std::string_view cell) const {
    fail(Status::kFormat, "%s, line %zu: %s \"%.*s\"", list_, number_, what,
         static_cast<int>(std::min<size_t>(cell.size(), kQuoted)), cell.data());
  }

 private:
  // The next line with anything on it.
  bool advance() {
    while (!text_.empty()) {
      const size_t end = text_.find('\n');
      line_ = text_.substr(0, end);
      text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
      ++number_;
      const size_t first = line_.find_first_not_of(" \t\r");
      if (first != std::string_view::npos && line_[first] != '#') return true;
    }
    return false;
  }

  const char* list_;
  std::string_view text_, line_;
  char separator_ = ' ';
  size_t number_ = 0;
  std::map<std::string_view, size_t> columns_;
  Cells cells_;
};

class Numbering {
 public:
  explicit Numbering(std::vector<SurveyPoint>& points) : points_(points) {}
  uint32_t of(std::string_view id) {
    const auto [at, is_new] = numbers_.emplace(id, static_cast<uint32_t>(points_.size()));
    if (is_new) points_.emplace_back().id = id;
    return at->second;
  }

 private:
  std::vector<SurveyPoint>& points_;
  std::map<std::string, uint32_t, std::less<>> numbers_;
};

void read_points(std::string_view text, Survey& survey, Numbering& numbers) {
  static constexpr const char* kKnown[] = {"id", "x", "y", "z", "sx", "sy", "sz", "code"};
  NamedLines lines("points", text, kKnown);
  while (lines.next()) {
    const size_t before = survey.points.size();
    const std::string_view id = lines.needed("id");
    const uint32_t number = numbers.of(id);
    if (survey.points.size() == before) lines.refuse("the point stands in the list already:", id);
    SurveyPoint& point = survey.points[number];
    point.line = lines.line();
    point.code = lines.text("code");
    point.position = {lines.number("x", NAN), lines.number("y", NAN), lines.number("z", NAN)};
    point.sigma_m = {lines.number("sx", NAN, 0), lines.number("sy", NAN, 0),
                     lines.number("sz", NAN, 0)};
    for (int axis = 0; axis < 3; ++axis)
      if (std::isfinite(point.sigma_m[axis]) && !std::isfinite(point.position[axis]))
        lines.refuse("a standard deviation without its coordinate: point", id);
  }
}

double in_radians(double value, AngleUnit unit) {
  if (unit == AngleUnit::kRadian) return value;
  return value * (kHalfTurn_rad / (unit == AngleUnit::kGon ? 200 : 180));
}

// Both faces tell the same angle: the second one from the other side.
void turn_to_first_face(SurveySight& sight) {
  if (!(sight.zenith_rad > kHalfTurn_rad)) return;
  sight.zenith_rad = 2 * kHalfTurn_rad - sight.zenith_rad;
  sight.direction_rad -= kHalfTurn_rad;
}

void read_observations(std::string_view text, AngleUnit unit, Survey& survey, Numbering& numbers) {
  static constexpr const char* kKnown[] = {
      "from",  "to",   "direction",       "zenith",       "distance",       "instrument_height",
      "setup", "code", "sigma_direction", "sigma_zenith", "sigma_distance", "target_height"};
  NamedLines lines("observations", text, kKnown);
  const auto angle = [&](const char* name) { return in_radians(lines.number(name, NAN), unit); };
  while (lines.next()) {
    SurveySight sight;
    sight.line = lines.line();
    const uint32_t from = numbers.of(lines.needed("from"));
    sight.target = numbers.of(lines.needed("to"));
    if (sight.target == from) lines.refuse("a point that sights itself:", lines.text("to"));
    const std::string setup(lines.text("setup"));
    if (survey.setups.empty() || survey.setups.back().station != from ||
        survey.setups.back().name != setup)
      survey.setups.push_back({setup, from});
    sight.setup = static_cast<uint32_t>(survey.setups.size() - 1);
    sight.direction_rad = angle("direction");
    sight.zenith_rad = angle("zenith");
    sight.distance_m = lines.number("distance", NAN);
    sight.instrument_height_m = lines.number("instrument_height", 0);
    sight.target_height_m = lines.number("target_height", 0);
    sight.sigma_direction_rad = in_radians(lines.number("sigma_direction", NAN, 0), unit);
    sight.sigma_zenith_rad = in_radians(lines.number("sigma_zenith", NAN, 0), unit);
    sight.sigma_distance_m = lines.number("sigma_distance", NAN, 0);
    for (const double sigma :
         {sight.sigma_direction_rad, sight.sigma_zenith_rad, sight.sigma_distance_m})
      if (sigma == 0) lines.refuse("a standard deviation of 0 to", lines.text("to"));
    if (sight.zenith_rad <= 0 || sight.zenith_rad >= 2 * kHalfTurn_rad)
      lines.refuse("no zenith angle:", lines.text("zenith"));
    if (sight.distance_m <= 0) lines.refuse("no distance:", lines.text("distance"));
    turn_to_first_face(sight);
    SurveyPoint& target = survey.points[sight.target];
    if (target.code.empty()) target.code = lines.text("code");
    survey.sightings.push_back(sight);
  }
}

}  // namespace

Survey read_survey(std::string_view points, std::string_view observations, AngleUnit unit) {
  Survey survey;
  Numbering numbers(survey.points);
  read_points(points, survey, numbers);
  read_observations(observations, unit, survey, numbers);
  return survey;
}

}  // namespace jalon
