// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/options.h"

#include <array>
#include <charconv>
#include <cmath>

#include "cli/text_file.h"

namespace jalon::cli {

void ViewerOption::add_to(Command& command) {
  command
      .option("--viewer-points", points,
              "Most points of the report's view in three dimensions, evenly taken; 0: no view")
      .between(0, 1000000000)
      .default_text("1000000")
      .type_name("N");
}

Params ViewerOption::params(const char* operation) const {
  Params options = make_params(operation);
  if (points >= 0) must(jalon_params_set_int64(options.get(), "viewer_points", points));
  return options;
}

void add_common(Command& command, Common& common) {
  command.flag("-q,--quiet", common.quiet, "Print nothing but errors");
  command.flag("--json", common.json, "Print the result as one JSON object");
  command
      .option("--threads", common.threads,
              "Threads; 0 = all processors. The result does not depend on it")
      .between(0, 256);
  command
      .option("--memory-limit", common.memory_limit_mib,
              "Most memory that a step may take beside its input, in MiB; 0: no limit")
      .type_name("MIB");
}

void Settings::add_to(Command& command, const std::string& name_prefix) {
  prefix = name_prefix;
  command
      .option("--" + prefix + "set", assignments,
              "Set a parameter, e.g. --" + prefix + "set min_area_m2=0.2 (repeatable)")
      .type_name("NAME=VALUE")
      .one_each_time();
  command.option("--" + prefix + "params", json_file, "Read parameters from a JSON file")
      .type_name("FILE");
}

void Settings::add_short_to(Command& command) {
  command.option("--set", short_assignments, "The same as --" + prefix + "set")
      .type_name("NAME=VALUE")
      .one_each_time();
  command.option("--params", short_json_file, "The same as --" + prefix + "params")
      .type_name("FILE");
}

bool Settings::sets(const std::string& name) const {
  for (const auto* all : {&assignments, &short_assignments})
    for (const std::string& assignment : *all)
      if (assignment.starts_with(name + "=")) return true;
  return false;
}

namespace {

// What people write, and the choices of the parameter "unit".
constexpr const char* kUnits[][2] = {{"m", "metre"},
                                     {"cm", "centimetre"},
                                     {"mm", "millimetre"},
                                     {"ft", "foot"},
                                     {"us-ft", "us_survey_foot"}};

Failure usage(std::string text) { return {JALON_ERROR_INVALID_ARGUMENT, std::move(text)}; }

jalon_param_info info_of(jalon_params* params, const std::string& name) {
  uint64_t count = 0;
  must(jalon_params_count(params, &count));
  std::string names;
  for (uint64_t i = 0; i < count; ++i) {
    jalon_param_info info{};
    info.struct_size = sizeof info;
    must(jalon_params_info(params, i, &info));
    if (name == info.name) return info;
    names += (names.empty() ? "" : ", ") + std::string(info.name);
  }
  throw usage("no parameter \"" + name + "\"; there are: " + names);
}

// "1,2,3", "[1, 2, 3]" or "1 2 3"; "" and "[]" hold nothing.
bool are_numbers(std::string text, std::vector<double>& out) {
  if (text.starts_with('[') && text.ends_with(']')) text = text.substr(1, text.size() - 2);
  size_t end = 0;
  out = leading_numbers(text, end);
  return end == text.size();
}

bool is_whole(const std::string& text, int64_t& out) {
  const char* last = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), last, out);
  return error == std::errc() && stop == last;
}

}  // namespace

void assign(jalon_params* params, const std::string& option, const std::string& assignment) {
  const size_t equal = assignment.find('=');
  if (equal == std::string::npos || equal == 0)
    throw usage(option + " needs NAME=VALUE, not \"" + assignment + "\"");
  const std::string name = assignment.substr(0, equal), value = assignment.substr(equal + 1);
  const auto refuse = [&](const std::string& why) {
    throw usage(option + " " + assignment + ": " + why);
  };
  std::vector<double> numbers;
  int64_t whole = 0;
  jalon_status set = JALON_OK;
  switch (info_of(params, name).type) {
    case JALON_PARAM_DOUBLES:
      if (!are_numbers(value, numbers)) refuse(name + " takes numbers, as " + name + "=1,2,3");
      set = jalon_params_set_doubles(params, name.c_str(), numbers.data(), numbers.size());
      break;
    case JALON_PARAM_BOOL:
      if (value != "true" && value != "false") refuse(name + " takes true or false");
      set = jalon_params_set_bool(params, name.c_str(), value == "true");
      break;
    case JALON_PARAM_DOUBLE:
    case JALON_PARAM_INT64:
      if (is_whole(value, whole)) {
        set = jalon_params_set_int64(params, name.c_str(), whole);
        break;
      }
      if (!are_numbers(value, numbers) || numbers.size() != 1) refuse(name + " takes a number");
      set = jalon_params_set_double(params, name.c_str(), numbers[0]);
      break;
    default:
      set = jalon_params_set_string(params, name.c_str(), value.c_str());
  }
  if (set != JALON_OK) refuse(jalon_last_error_message());
}

void Settings::apply(jalon_params* params) const {
  for (const std::string& file : {json_file, short_json_file})
    if (!file.empty() && jalon_params_from_json(params, read_text_file(file).c_str()) != JALON_OK)
      throw usage(file + ": " + jalon_last_error_message());
  for (const std::string& assignment : assignments)
    assign(params, "--" + prefix + "set", assignment);
  for (const std::string& assignment : short_assignments) assign(params, "--set", assignment);
}

Params make_params(const char* operation) {
  Params params;
  must(jalon_params_create(operation, Out(params)));
  return params;
}

std::string describe(jalon_params* params) {
  uint64_t count = 0;
  must(jalon_params_count(params, &count));
  std::string text;
  for (uint64_t i = 0; i < count; ++i) {
    jalon_param_info info{};
    info.struct_size = sizeof info;
    must(jalon_params_info(params, i, &info));
    text += "  " + std::string(info.name) + " = " + info.default_text;
    if (*info.unit != 0 && std::string(info.unit) != "1") text += " " + std::string(info.unit);
    if (*info.choices != 0) text += "  (" + std::string(info.choices) + ")";
    text += "\n      " + std::string(info.help) + "\n";
  }
  return text;
}

void Input::add_to(Command& command, bool required) {
  command
      .option("scan", path,
              "Scan file: LAS, LAZ, COPC, EPT, E57, PTX, PTS, PCD, PLY, XYZ, TXT, CSV")
      .required(required)
      .type_name("SCAN");
  add_reading_to(command);
}

namespace {

void add_drop_invalid(Command& command, std::function<void()> on_given) {
  command.flag("--drop-invalid", std::move(on_given),
               "Drop points whose coordinates are not finite");
}

}  // namespace

void Input::add_reading_to(Command& command, const std::string& prefix) {
  add_points_to(command, prefix);
  command
      .option(
          "--" + prefix + "station", station,
          "Where the scanner stood, for all points: tells the front of surfaces and what was seen")
      .type_name("X,Y,Z");
}

void Input::add_points_to(Command& command, const std::string& prefix) {
  command
      .option("--" + prefix + "columns", columns,
              "Columns of a text file, e.g. \"x y z intensity\"; - skips one")
      .type_name("NAMES");
  add_unit_to(command, "--" + prefix + "unit");
  if (prefix.empty()) add_drop_invalid(command, [this] { drop_invalid = true; });
  command
      .option(
          "--" + prefix + "box", box,
          "Read the points of this box alone, its least corner and its greatest, in metres; of a "
          "COPC file only what it touches is read")
      .type_name("X,Y,Z,X,Y,Z");
  command
      .option("--" + prefix + "spacing", spacing_m,
              "Read the levels of a COPC file down to this spacing of their points, in metres")
      .type_name("M");
  command
      .option("--" + prefix + "only-station", only_station,
              "Read the points of this scan station alone: its name, or its number from 1")
      .type_name("NAME");
  command
      .option("--" + prefix + "max-points", max_points,
              "Keep at most so many points, evenly taken; 0: all")
      .type_name("N");
  command
      .option("--" + prefix + "fields", fields,
              "Fields to read, e.g. \"intensity classification\"; one with ? behind it may be "
              "missing; - "
              "reads none")
      .type_name("NAMES");
}

void add_output_folder(Command& command, std::string& output) {
  command.option("-o,--output", output, "Folder for the results").required().type_name("DIR");
}

void add_reading_of_two(Command& command, Input& first, const std::string& first_prefix,
                        Input& second, const std::string& second_prefix) {
  first.add_reading_to(command, first_prefix);
  second.add_reading_to(command, second_prefix);
  add_drop_invalid(command, [both = std::array{&first, &second}] {
    for (Input* input : both) input->drop_invalid = true;
  });
}

bool Input::is_told() const {
  return !unit.empty() || !station.empty() || !columns.empty() || !box.empty() || spacing_m != 0 ||
         !only_station.empty() || max_points != 0 || !fields.empty();
}

void Input::add_unit_to(Command& command, const std::string& option) {
  unit_option = option;
  command
      .option(option, unit,
              "Unit of the coordinates, which become metres; else that of the CRS of a LAS file, "
              "else taken for metres")
      .among({"m", "cm", "mm", "ft", "us-ft"});
}

namespace {

// Numbers between commas.
template <size_t N>
std::array<double, N> numbers_in(const std::string& text, const std::string& need) {
  std::array<double, N> numbers{};
  const char *rest = text.data(), *last = text.data() + text.size();
  for (size_t k = 0; k < N; ++k) {
    const auto [end, error] = std::from_chars(rest, last, numbers[k]);
    const bool is_ended = k + 1 == N ? end == last : end != last && *end == ',';
    if (error != std::errc() || !is_ended || !std::isfinite(numbers[k]))
      throw usage(need + ", not \"" + text + "\"");
    rest = k + 1 == N ? end : end + 1;
  }
  return numbers;
}

}  // namespace

Params Input::reading(const char* operation) const {
  Params params = make_params(operation);
  if (!columns.empty()) must(jalon_params_set_string(params.get(), "columns", columns.c_str()));
  for (const auto& [name, kind] : kUnits)
    if (unit == name) must(jalon_params_set_string(params.get(), "unit", kind));
  if (drop_invalid) must(jalon_params_set_bool(params.get(), "drop_invalid", 1));
  if (!box.empty()) {
    const auto corners = numbers_in<6>(box, "a box needs X,Y,Z,X,Y,Z in metres");
    must(jalon_params_set_doubles(params.get(), "box", corners.data(), corners.size()));
  }
  must(jalon_params_set_double(params.get(), "spacing_m", spacing_m));
  must(jalon_params_set_string(params.get(), "station", only_station.c_str()));
  must(jalon_params_set_int64(params.get(), "max_points", max_points));
  must(jalon_params_set_string(params.get(), "fields", fields.c_str()));
  return params;
}

Cloud Input::read(Console& console) const {
  const Params params = reading("read");
  Cloud cloud;
  const bool has_station = !station.empty();
  const jalon_transform pose = has_station ? pose_at(station) : jalon_transform{};
  must_read(jalon_cloud_read(path.c_str(), params.get(), console.task(), Out(cloud)));
  if (has_station) must(jalon_cloud_set_station(cloud.get(), "station", &pose));
  return cloud;
}

jalon_transform pose_at(const std::string& text) {
  const auto [x, y, z] = numbers_in<3>(text, "a station needs X,Y,Z in metres");
  return {{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z}};
}

uint64_t count_of(const Cloud& cloud) {
  uint64_t count = 0;
  must(jalon_cloud_count(cloud.get(), &count));
  return count;
}

bool has_all_stations(const Cloud& cloud) {
  uint64_t stations = 0, placed = 0;
  must(jalon_cloud_station_count(cloud.get(), &stations));
  for (uint64_t i = 0; i < stations; ++i) {
    int32_t has_pose = 0;
    uint64_t points = 0;
    must(jalon_cloud_station(cloud.get(), i, nullptr, &has_pose, nullptr, nullptr, &points));
    if (has_pose != 0) placed += points;
  }
  return placed > 0 && placed == count_of(cloud);
}

}  // namespace jalon::cli
