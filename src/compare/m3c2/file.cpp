// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

namespace {

// Keys that say what to write, how to spread the work, or repeat what another one switches on.
constexpr std::string_view kWithoutEffect[] = {"M3C2VER",
                                               "ProjDestIndex",
                                               "UseOriginalCloud",
                                               "ExportStdDevInfo",
                                               "ExportDensityAtProjScale",
                                               "MaxThreadCount",
                                               "PM1Scale",
                                               "PM2Scale",
                                               "UseSinglePass4Depth"};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// What a file says, fit for a line of a log.
std::string shown(std::string_view text) {
  constexpr size_t kMost = 60;
  std::string out(text.substr(0, kMost));
  for (char& c : out)
    if (c < ' ' || c == '\x7f') c = '?';
  return out;
}

/// The keys of the file, each taken at most once; the last line of a key counts.
class Keys {
 public:
  explicit Keys(std::string_view text) {
    size_t line_number = 0;
    while (!text.empty()) {
      const size_t end = std::min(text.find('\n'), text.size());
      ++line_number;
      add(trimmed(text.substr(0, end)), line_number);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  bool has(std::string_view key) const { return values_.find(key) != values_.end(); }
  /// False when the key is absent.
  bool take(std::string_view key, double& out) {
    const std::string* text = take(key);
    if (text == nullptr) return false;
    if (!parse_number(*text, out) || !std::isfinite(out))
      fail(Status::kFormat, "M3C2 file: %.*s=%.60s is no number", static_cast<int>(key.size()),
           key.data(), text->c_str());
    return true;
  }
  bool take(std::string_view key, bool& out) {
    const std::string* text = take(key);
    if (text == nullptr) return false;
    if (*text != "true" && *text != "false" && *text != "1" && *text != "0")
      fail(Status::kFormat, "M3C2 file: %.*s=%.60s is neither true nor false",
           static_cast<int>(key.size()), key.data(), text->c_str());
    out = *text == "true" || *text == "1";
    return true;
  }
  void skip(std::string_view key) { take(key); }
  std::vector<std::string> left() const {
    std::vector<std::string> lines;
    for (const auto& [key, value] : values_)
      if (!taken_.contains(key))
        lines.push_back("M3C2 file: " + shown(key) + "=" + shown(value) +
                        " is not known and has no effect");
    return lines;
  }

 private:
  void add(std::string_view line, size_t number) {
    if (line.empty() || line[0] == ';' || line[0] == '#' || line[0] == '[') return;
    const size_t equal = line.find('=');
    if (equal == std::string_view::npos)
      fail(Status::kFormat, "M3C2 file: line %zu is not key=value", number);
    values_[std::string(trimmed(line.substr(0, equal)))] =
        std::string(trimmed(line.substr(equal + 1)));
  }
  const std::string* take(std::string_view key) {
    const auto found = values_.find(key);
    if (found == values_.end()) return nullptr;
    taken_[found->first] = true;
    return &found->second;
  }

  std::map<std::string, std::string, std::less<>> values_;
  std::map<std::string, bool, std::less<>> taken_;
};

[[noreturn]] void refuse(const char* what) {
  fail(Status::kUnsupported, "M3C2 file: %s has no counterpart here and would change the distances",
       what);
}

// Smallest, step and largest diameter of the multi-scale mode, as radii.
void read_scales(Keys& keys, bool multiscale, ParamSet& params) {
  double smallest = 0, step = 0, largest = 0;
  const bool given = keys.take("NormalMinScale", smallest);
  if ((!keys.take("NormalStep", step) | !keys.take("NormalMaxScale", largest) | !given) &&
      multiscale)
    fail(Status::kFormat,
         "M3C2 file: the multi-scale mode lacks NormalMinScale, NormalStep or NormalMaxScale");
  std::vector<double> radii_m;
  if (multiscale) {
    constexpr double kMost = 100;
    const double steps = step > 0 ? std::floor((largest - smallest) / step * (1 + 1e-9)) : 0;
    if (!(smallest > 0) || steps >= kMost)
      fail(Status::kFormat,
           "M3C2 file: its multi-scale mode has a scale of 0 or more than 100 scales");
    for (double i = 0; i <= steps; ++i) radii_m.push_back(0.5 * (smallest + i * step));
  }
  params.set_numbers("normal_radii_m", radii_m);
}

// The numbers of the plug-in: 0 by scale, 1 those of cloud 1, 2 multi-scale, 3 vertical, 4 horizontal, 5 those of the
// core points.
void read_normals(Keys& keys, ParamSet& params) {
  double diameter = 0, mode = 0;
  bool from_core = false;
  if (keys.take("NormalScale", diameter)) params.set_number("normal_radius_m", 0.5 * diameter);
  const bool has_mode = keys.take("NormalMode", mode);
  read_scales(keys, mode == 2, params);
  if (has_mode) {
    constexpr const char* kModes[] = {"scale", "given", "scale", "vertical", "horizontal", "given"};
    if (!(mode >= 0 && mode <= 5 && mode == std::floor(mode))) refuse("this NormalMode");
    params.set_text("normals", kModes[static_cast<size_t>(mode)]);
  }
  if (keys.take("NormalUseCorePoints", from_core))
    params.set_text("normals_from", from_core ? "core" : "reference");
}

// The numbers since CloudCompare 2.10: 0 to 5 are +x -x +y -y +z -z, 11 the sensor.
void read_orientation(Keys& keys, ParamSet& params) {
  double number = 0;
  if (!keys.take("NormalPreferedOri", number)) return;
  if (number == 11) return params.set_text("orientation", "station");
  if (!(number >= 0 && number <= 5 && number == std::floor(number)))
    refuse("this NormalPreferedOri");
  const auto axis = static_cast<size_t>(number);
  std::array<double, 3> direction{};
  direction[axis / 2] = axis % 2 == 0 ? 1 : -1;
  params.set_text("orientation", "direction");
  params.set_numbers("orientation_direction", direction);
}

void read_cylinders(Keys& keys, ParamSet& params) {
  double diameter = 0, depth_m = 0, points = 0;
  bool median = false, limited = false, positive_only = false, precision_maps = false;
  if (keys.take("SearchScale", diameter)) params.set_number("cylinder_radius_m", 0.5 * diameter);
  if (keys.take("SearchDepth", depth_m)) params.set_number("max_depth_m", depth_m);
  if (keys.take("UseMedian", median)) params.set_text("position", median ? "median" : "mean");
  const bool has_points = keys.take("MinPoints4Stat", points);
  constexpr double kFewest = 3;
  if (keys.take("UseMinPoints4Stat", limited) && limited && has_points)
    params.set_number("min_points", std::max(kFewest, points));
  if (keys.take("PositiveSearchOnly", positive_only) && positive_only)
    refuse("PositiveSearchOnly=true");
  if (keys.take("UsePrecisionMaps", precision_maps) && precision_maps)
    fail(Status::kUnsupported,
         "M3C2 file: UsePrecisionMaps=true: give the clouds the field \"covariance\" and set "
         "precision_from = covariances instead");
  params.set_text("surfaces", "all");
}

void read_rest(Keys& keys, ParamSet& params) {
  double spacing_m = 0, error_m = 0;
  bool sampled = true, registered = true;
  const bool has_spacing = keys.take("SubsampleRadius", spacing_m),
             has_error = keys.take("RegistrationError", error_m);
  keys.take("SubsampleEnabled", sampled);
  keys.take("RegistrationErrorEnabled", registered);
  if (has_spacing || !sampled) params.set_number("core_spacing_m", sampled ? spacing_m : 0);
  if (has_error || !registered) params.set_number("registration_error_m", registered ? error_m : 0);
}

}  // namespace

std::vector<std::string> read_cloudcompare_m3c2(std::string_view text, ParamSet& params) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  Keys keys(text);
  if (!keys.has("M3C2VER"))
    fail(Status::kFormat, "not an M3C2 parameter file: it has no key M3C2VER");
  ParamSet set = params;
  read_normals(keys, set);
  read_orientation(keys, set);
  read_cylinders(keys, set);
  read_rest(keys, set);
  for (const std::string_view key : kWithoutEffect) keys.skip(key);
  std::vector<std::string> warnings = keys.left();
  params = std::move(set);
  return warnings;
}

}  // namespace jalon
