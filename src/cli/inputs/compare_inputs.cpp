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

std::string use_stations(const Cloud& reference, const Cloud& compared, bool both,
                         const Settings& settings, const Params& params) {
  if (has_stations(reference) && (!both || has_stations(compared))) {
    must(jalon_params_set_string(params.get(), "visibility", "stations"));
    must(jalon_params_set_string(params.get(), "local_model", "plane"));
    must(jalon_params_set_bool(params.get(), "reference_spacing", 1));
    settings.apply(params.get());
  }
  const char* visibility = nullptr;
  must(jalon_params_get_string(params.get(), "visibility", &visibility));
  if (std::string(visibility) == "stations")
    return "what the scanners could not see has no distance";
  return "not told apart, may show as changes: --reference-station and --compared-station give the "
         "scanners' places";
}

}  // namespace jalon::cli
