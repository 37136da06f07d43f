// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/inputs/compare_inputs.h"

#include <algorithm>
#include <cmath>

#include "cli/lengths.h"

namespace jalon::cli {

namespace {

// "x 1.2 ... 3.4, y ..."
std::string ranges_of(const jalon_box& box) {
  const auto range = [](const char* name, double low, double high) {
    return std::string(name) + " " + fixed(low, 1) + " ... " + fixed(high, 1);
  };
  return range("x", box.min.x, box.max.x) + ", " + range("y", box.min.y, box.max.y) + ", " +
         range("z", box.min.z, box.max.z);
}

std::string axes_of(const Fields& overlap) {
  const int8_t* axes = values<int8_t>(overlap, "axes");
  std::string text;
  for (int k = 0; k < 3; ++k) {
    if (k > 0) text += ", ";
    if (axes[k] < 0) text += "-";
    text += "xyz"[std::abs(axes[k]) - 1];
  }
  return text;
}

const char* unit_of_factor(double factor) {
  struct Named {
    double factor;
    const char* name;
  };
  static constexpr Named kNamed[] = {{0.3048, "feet"},       {1200.0 / 3937, "US survey feet"},
                                     {0.0254, "inches"},     {0.01, "centimetres"},
                                     {0.001, "millimetres"}, {1000, "kilometres"}};
  for (const Named& unit : kNamed)
    if (std::abs(factor / unit.factor - 1) < 1e-9) return unit.name;
  return nullptr;
}

std::string cause_of(const Fields& overlap, const Input& reference, const Input& compared) {
  const double factor = *values<double>(overlap, "factor");
  const double* shift = values<double>(overlap, "shift");
  switch (*values<uint8_t>(overlap, "cause")) {
    case JALON_APART_AXES:
      return "likely other axes: they meet where (" + axes_of(overlap) + ") of " + compared.path +
             " are taken for (x, y, z)";
    case JALON_APART_UNIT: {
      const char* unit = unit_of_factor(factor);
      return "likely another unit: as if " + (unit != nullptr ? compared.path : reference.path) +
             " were in " + (unit != nullptr ? unit : unit_of_factor(1 / factor)) + "; " +
             (unit != nullptr ? compared : reference).unit_option + " names it";
    }
    case JALON_APART_ORIGIN:
      return "likely another origin or CRS: of the same size, " + compared.path +
             " shifted by about " + fixed(shift[0], 0) + ", " + fixed(shift[1], 0) + ", " +
             fixed(shift[2], 0) + " meets it; \"jalon register\" finds the pose";
    case JALON_APART_DEGREES:
      return "likely one is in degrees of longitude and latitude";
    default:
      return "they may have other units, axes or CRS";
  }
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

void use_box(const std::string& box, std::initializer_list<Input*> inputs) {
  if (box.empty()) return;
  bool is_used = false;
  for (Input* input : inputs) {
    if (input->path.empty() || is_model_file(input->path)) continue;
    if (input->box.empty()) input->box = box;
    is_used = true;
  }
  if (!is_used) throw Failure{JALON_ERROR_INVALID_ARGUMENT, "--box is of scans, not of models"};
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
  const bool known = has_all_stations(reference) && (!both || has_all_stations(compared));
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

Cloud where(const Console& console, const Model& model, const Cloud& cloud) {
  Cloud out;
  if (model == nullptr) {
    must(jalon_cloud_copy(cloud.get(), Out(out)));
    return out;
  }
  constexpr int64_t kEnough = 20000;
  const Params options = make_params("model_sample");
  must(jalon_params_set_int64(options.get(), "points", kEnough));
  must(jalon_model_sample(model.get(), options.get(), console.task(), Out(out)));
  return out;
}

void refuse_apart(const Console& console, const Placed& reference, const Placed& compared,
                  bool is_forced) {
  const Cloud &before = reference.points, &after = compared.points;
  const char *crs_before = "", *crs_after = "";
  must(jalon_cloud_crs(before.get(), &crs_before));
  must(jalon_cloud_crs(after.get(), &crs_after));
  if (*crs_before != 0 && *crs_after != 0 && std::string(crs_before) != crs_after)
    return;  // the comparer refuses that
  Fields overlap;
  must(jalon_cloud_overlap(before.get(), after.get(), console.task(), Out(overlap)));
  const bool is_apart = *values<uint8_t>(overlap, "apart") != 0;
  if (!is_apart && *values<uint8_t>(overlap, "cause") == JALON_APART_UNKNOWN) return;
  const double gap = *values<double>(overlap, "gap");
  const double of_before = *values<double>(overlap, "reference_share"),
               of_after = *values<double>(overlap, "compared_share");
  const double share = is_apart ? std::max(of_before, of_after) : std::min(of_before, of_after);
  const std::string line = reference.input.path + " (" + ranges_of(box_of(before)) + ") and " +
                           compared.input.path + " (" + ranges_of(box_of(after)) + ") " +
                           (gap > 0 ? "lie " + fixed(gap, 1) + " apart"
                                    : "share " + fixed(100 * share, 1) + " % of their space") +
                           ": " + cause_of(overlap, reference.input, compared.input);
  if (is_apart && !is_forced)
    throw Failure{JALON_ERROR_DEGENERATE, line + "; nothing is written, --force compares them"};
  console.warn(line);
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
  if (!none && has_all_stations(reference))
    return "what the scanners could not see has no distance";
  if (!none)
    return "what the scanners could not see has no distance; where they stood is found by the "
           "order of the points";
  return "not told apart, may show as changes: --reference-station and --compared-station give the "
         "scanners' places";
}

void warn_of_misalignment(const Console& console, const Table& summary) {
  if (!summary.has("misalignment")) return;
  const double misalignment = summary.number("misalignment", 0);
  constexpr double kLeastTold_m = 1e-4;  // less are the digits of the files
  constexpr double kScanners_m =
      0.002;  // noise of scanners: what is noise beyond is roughness, which hides no misfit
  const double noise = std::min(kScanners_m, summary.number("noise", 0));
  if (!(misalignment > std::max(kLeastTold_m, noise))) return;
  console.warn("most surfaces of both scans differ by " + fixed(1000 * misalignment, 1) +
               " mm (standard deviation) beside noise, as where stations or epochs are registered "
               "no better; smaller changes cannot be told from it: see jalon register");
}

double deciding_threshold(const Table& summary, const Params& change_options) {
  const char* criterion = nullptr;
  must(jalon_params_get_string(change_options.get(), "criterion", &criterion));
  const std::string by = criterion;
  const bool has_tests = summary.has("tests") || summary.has("mean_lod");
  if (by == "significance" || by == "field" || (by == "automatic" && has_tests)) return 0;
  double threshold = 0;
  must(jalon_params_get_double(change_options.get(), "threshold_m", &threshold));
  return threshold;
}

}  // namespace jalon::cli
