// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/options.h"

#include <charconv>
#include <cmath>

#include "cli/text_file.h"

namespace jalon::cli {

void add_common(Command& command, Common& common) {
  command.flag("-q,--quiet", common.quiet, "Print nothing but errors");
  command.flag("--json", common.json, "Print the result as one JSON object");
  command
      .option("--threads", common.threads,
              "Threads; 0 = all processors. The result does not depend on it")
      .between(0, 256);
}

void Settings::add_to(Command& command, const std::string& prefix) {
  command
      .option("--" + prefix + "set", assignments,
              "Set a parameter, e.g. --" + prefix + "set min_area_m2=0.2 (repeatable)")
      .type_name("NAME=VALUE")
      .one_each_time();
  command.option("--" + prefix + "params", json_file, "Read parameters from a JSON file")
      .type_name("FILE");
}

namespace {

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

// Texts are set as they are; all other values are written as JSON, which the library checks.
void assign(jalon_params* params, const std::string& name, const std::string& value) {
  const int32_t type = info_of(params, name).type;
  if (type == JALON_PARAM_STRING || type == JALON_PARAM_CHOICE)
    return must(jalon_params_set_string(params, name.c_str(), value.c_str()));
  const bool bare_list = type == JALON_PARAM_DOUBLES && value.find('[') == std::string::npos;
  const std::string json = bare_list ? "[" + value + "]" : value;
  if (jalon_params_from_json(params, ("{\"" + name + "\":" + json + "}").c_str()) != JALON_OK)
    throw usage("--set " + name + "=" + value + ": " + jalon_last_error_message());
}

}  // namespace

void Settings::apply(jalon_params* params) const {
  if (!json_file.empty()) must(jalon_params_from_json(params, read_text_file(json_file).c_str()));
  for (const std::string& assignment : assignments) {
    const size_t equal = assignment.find('=');
    if (equal == std::string::npos || equal == 0)
      throw usage("--set needs NAME=VALUE, not \"" + assignment + "\"");
    assign(params, assignment.substr(0, equal), assignment.substr(equal + 1));
  }
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
  command.option("scan", path, "Scan file: LAS, PLY, XYZ, TXT, CSV")
      .required(required)
      .type_name("SCAN");
  command
      .option("--columns", columns, "Columns of a text file, e.g. \"x y z intensity\"; - skips one")
      .type_name("NAMES");
  command
      .option(
          "--station", station,
          "Where the scanner stood, for all points: tells the front of surfaces and what was seen")
      .type_name("X,Y,Z");
  command.flag("--drop-invalid", drop_invalid, "Drop points whose coordinates are not finite");
}

Cloud Input::read(Console& console) const {
  Params params = make_params("read");
  if (!columns.empty()) must(jalon_params_set_string(params.get(), "columns", columns.c_str()));
  if (drop_invalid) must(jalon_params_set_bool(params.get(), "drop_invalid", 1));
  Cloud cloud;
  const bool has_station = !station.empty();
  const jalon_transform pose = has_station ? pose_at(station) : jalon_transform{};
  must(jalon_cloud_read(path.c_str(), params.get(), console.task(), Out(cloud)));
  if (has_station) must(jalon_cloud_set_station(cloud.get(), "station", &pose));
  return cloud;
}

jalon_transform pose_at(const std::string& text) {
  jalon_transform pose{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
  const char *rest = text.data(), *last = text.data() + text.size();
  for (const int k : {3, 7, 11}) {
    const auto [end, error] = std::from_chars(rest, last, pose.m[k]);
    const bool is_ended = k == 11 ? end == last : end != last && *end == ',';
    if (error != std::errc() || !is_ended)
      throw usage("--station needs X,Y,Z in metres, not \"" + text + "\"");
    rest = k == 11 ? end : end + 1;
  }
  return pose;
}

uint64_t count_of(const Cloud& cloud) {
  uint64_t count = 0;
  must(jalon_cloud_count(cloud.get(), &count));
  return count;
}

}  // namespace jalon::cli
