// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/inputs/compare_inputs.h"

#include <algorithm>

namespace jalon::cli {

namespace {

bool has_stations(const Cloud& cloud) {
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

}  // namespace

bool is_model_file(const std::string& path) {
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return std::ranges::any_of(std::initializer_list<const char*>{".obj", ".stl", ".json"},
                             [&](const char* end) { return lower.ends_with(end); });
}

Cloud sampled(const Console& console, const Model& model, const Settings& settings) {
  const Params options = make_params("model_sample");
  settings.apply(options.get());
  Cloud out;
  must(jalon_model_sample(model.get(), options.get(), console.task(), Out(out)));
  return out;
}

void choose_for_scans(const Cloud& reference, const Cloud& compared, bool both,
                      const Settings& settings, const Params& params) {
  const bool known = has_stations(reference) && (!both || has_stations(compared));
  must(jalon_params_set_bool(params.get(), "detection", 1));
  must(jalon_params_set_string(params.get(), "visibility", known ? "stations" : "found"));
  settings.apply(params.get());
  int32_t detects = 0;
  must(jalon_params_get_bool(params.get(), "detection", &detects));
  if (detects != 0 || !known) return;
  must(jalon_params_set_string(params.get(), "local_model", "plane"));
  must(jalon_params_set_bool(params.get(), "reference_spacing", 1));
  settings.apply(params.get());
}

std::string said_of_shadows(const Cloud& reference, const Params& params, const Table& forward,
                            const Table* reverse) {
  const char* visibility = nullptr;
  must(jalon_params_get_string(params.get(), "visibility", &visibility));
  const auto has_none = [](const Table& summary) {
    return summary.has("stations") && summary.count("stations", 0) == 0;
  };
  const bool none = std::string(visibility) == "none" || has_none(forward) ||
                    (reverse != nullptr && has_none(*reverse));
  if (!none && has_stations(reference)) return "what the scanners could not see has no distance";
  if (!none)
    return "what the scanners could not see has no distance; where they stood is found by the "
           "order of the points";
  return "not told apart, may show as changes: --reference-station and --compared-station give the "
         "scanners' places";
}

}  // namespace jalon::cli
