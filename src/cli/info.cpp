// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/lengths.h"
#include "cli/options.h"

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

const char* type_name(int32_t type) {
  static constexpr const char* kNames[] = {"?",      "int8",    "uint8",  "int16",
                                           "uint16", "int32",   "uint32", "int64",
                                           "uint64", "float32", "float64"};
  return kNames[type];
}

struct Range {
  double low = INFINITY, high = -INFINITY;
};

Range range_of(const jalon_array_view& view) {
  Range range;
  for (uint64_t i = 0; i < view.count; ++i)
    for (uint32_t c = 0; c < view.components; ++c) {
      const char* p = static_cast<const char*>(view.data) + i * view.stride_bytes;
      double v = 0;
      switch (view.type) {
        case JALON_INT8:
          v = reinterpret_cast<const int8_t*>(p)[c];
          break;
        case JALON_UINT8:
          v = reinterpret_cast<const uint8_t*>(p)[c];
          break;
        case JALON_INT16:
          v = reinterpret_cast<const int16_t*>(p)[c];
          break;
        case JALON_UINT16:
          v = reinterpret_cast<const uint16_t*>(p)[c];
          break;
        case JALON_INT32:
          v = reinterpret_cast<const int32_t*>(p)[c];
          break;
        case JALON_UINT32:
          v = reinterpret_cast<const uint32_t*>(p)[c];
          break;
        case JALON_INT64:
          v = static_cast<double>(reinterpret_cast<const int64_t*>(p)[c]);
          break;
        case JALON_UINT64:
          v = static_cast<double>(reinterpret_cast<const uint64_t*>(p)[c]);
          break;
        case JALON_FLOAT32:
          v = static_cast<double>(reinterpret_cast<const float*>(p)[c]);
          break;
        default:
          v = reinterpret_cast<const double*>(p)[c];
      }
      if (v < range.low) range.low = v;
      if (v > range.high) range.high = v;
    }
  return range;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

void show_fields(const Console& console, const Cloud& cloud, Json& json) {
  Fields fields;
  must(jalon_cloud_fields(cloud.get(), Out(fields)));
  uint64_t count = 0;
  must(jalon_fields_count(fields.get(), &count));
  json["fields"] = Json::array();
  for (uint64_t i = 0; i < count; ++i) {
    jalon_field_info info{};
    info.struct_size = sizeof info;
    must(jalon_fields_info(fields.get(), i, &info));
    jalon_array_view view;
    must(jalon_fields_view(fields.get(), info.name, &view));
    const Range range = range_of(view);
    json["fields"].push_back({{"name", info.name},
                              {"type", type_name(info.type)},
                              {"components", info.components},
                              {"unit", info.unit},
                              {"min", number(range.low)},
                              {"max", number(range.high)}});
    char line[256];
    std::snprintf(line, sizeof line, "  %-20s %-8s x%u  %s ... %s %s", info.name,
                  type_name(info.type), info.components, fixed(range.low, 3).c_str(),
                  fixed(range.high, 3).c_str(), info.unit);
    console.say(line);
  }
}

void show_stations(const Console& console, const Cloud& cloud, Json& json) {
  uint64_t count = 0;
  must(jalon_cloud_station_count(cloud.get(), &count));
  json["stations"] = Json::array();
  for (uint64_t i = 0; i < count; ++i) {
    const char* name = "";
    int32_t has_pose = 0;
    jalon_transform pose;
    uint64_t points = 0;
    must(jalon_cloud_station(cloud.get(), i, &name, &has_pose, &pose, nullptr, &points));
    json["stations"].push_back({{"name", name}, {"points", points}});
    std::string where = "pose unknown";
    if (has_pose != 0) {
      json["stations"].back()["position"] = {pose.m[3], pose.m[7], pose.m[11]};
      where = "at " + fixed(pose.m[3], 3) + " " + fixed(pose.m[7], 3) + " " + fixed(pose.m[11], 3);
    }
    console.say("station    " + std::string(name) + ": " + grouped(points) + " points, " + where);
  }
}

void run_info(const Common& common, const Input& input) {
  Console console(common);
  console.step("reading");
  const Cloud cloud = input.read(console);
  Json json{{"file", input.path}, {"points", count_of(cloud)}};
  console.say("file       " + input.path);
  console.say("points     " + grouped(count_of(cloud)));
  jalon_box box;
  const Lengths lengths = Lengths::of(input, cloud);
  const std::string unit = std::string(" ") + lengths.length();
  if (count_of(cloud) > 0) {
    must(jalon_cloud_bounds(cloud.get(), &box));
    json["min"] = {box.min.x, box.min.y, box.min.z};
    json["max"] = {box.max.x, box.max.y, box.max.z};
    console.say("min        " + fixed(box.min.x, 3) + " " + fixed(box.min.y, 3) + " " +
                fixed(box.min.z, 3) + unit);
    console.say("max        " + fixed(box.max.x, 3) + " " + fixed(box.max.y, 3) + " " +
                fixed(box.max.z, 3) + unit);
    console.say("size       " + fixed(box.max.x - box.min.x, 3) + " x " +
                fixed(box.max.y - box.min.y, 3) + " x " + fixed(box.max.z - box.min.z, 3) + unit);
  }
  const char* crs = "";
  must(jalon_cloud_crs(cloud.get(), &crs));
  json["crs"] = crs;
  json["unit"] = lengths.is_known() ? Json("metre") : Json(nullptr);
  const std::string text = crs;
  console.say("crs        " + (text.empty()       ? "unknown"
                               : text.size() > 90 ? text.substr(0, 87) + "..."
                                                  : text));
  if (!lengths.is_known()) console.say(lengths.note());
  show_stations(console, cloud, json);
  show_fields(console, cloud, json);
  console.result(json);
}

}  // namespace

void add_info(Command& app) {
  Command command = app.subcommand("info", "What a scan holds: points, box, CRS, stations, fields");
  auto common = std::make_shared<Common>();
  auto input = std::make_shared<Input>();
  input->add_to(command);
  add_common(command, *common);
  command.footer("Example: jalon info scan.las --json");
  command.on_run([=] { run_info(*common, *input); });
}

}  // namespace jalon::cli
