// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/lengths.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jalon::cli {

namespace {

// Two scans of one place differ in extent too: a power of ten within a quarter is none by chance.
constexpr double kFactorTolerance = 0.1;  // of the decimal logarithm

double diagonal(const jalon_box& box) {
  return std::hypot(box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z);
}

// Lengths of E57 are in metres (ASTM E2807).
bool is_in_metres(const std::string& path) {
  return path.ends_with(".e57") || path.ends_with(".E57");
}

}  // namespace

Lengths Lengths::of(const Input& input, const Cloud& cloud) {
  const char* crs = "";
  must(jalon_cloud_crs(cloud.get(), &crs));
  Lengths out;
  if (*crs == '\0' && input.unit.empty() && !is_in_metres(input.path))
    out.files_ = input.path, out.options_ = input.unit_option;
  return out;
}

Lengths Lengths::of(const std::string& path, const Model& model) {
  const char* crs = "";
  must(jalon_model_crs(model.get(), &crs));
  Lengths out;
  if (*crs == '\0') out.files_ = path;
  return out;
}

Lengths Lengths::with(const Lengths& other) const {
  if (is_known() || other.is_known()) return is_known() ? other : *this;
  const auto both = [](const std::string& a, const std::string& b) {
    return a.empty() || b.empty() || a == b ? a + (a == b ? "" : b) : a + " and " + b;
  };
  Lengths out;
  out.files_ = both(files_, other.files_);
  out.options_ = both(options_, other.options_);
  return out;
}

std::string Lengths::fine(double length_m, int decimals_mm) const {
  return is_known() ? fixed(1000 * length_m, decimals_mm) : fixed(length_m, decimals_mm + 3);
}

std::string Lengths::heading(const std::string& name, const char* unit, size_t width) const {
  const std::string text = is_known() ? name + " " + unit : name;
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string Lengths::note() const {
  if (is_known()) return "";
  const char* verb = options_.find(" and ") == std::string::npos ? " names them" : " name them";
  return "lengths are in the units of " + files_ + ", not named there and taken for metres" +
         (options_.empty() ? "" : "; " + options_ + verb);
}

std::string Lengths::in_report() const {
  return is_known() ? "metre" : "not named by " + files_ + ": taken as metres";
}

void found_nothing(const Input& input, const Cloud& cloud, const std::string& what,
                   const std::string& options) {
  const Lengths lengths = Lengths::of(input, cloud);
  const jalon_box box = box_of(cloud);
  const std::string unit = lengths.length();
  throw Failure{JALON_ERROR_DEGENERATE,
                input.path + ": found " + what + " in " + grouped(count_of(cloud)) +
                    " points over " + fixed(box.max.x - box.min.x, 3) + " x " +
                    fixed(box.max.y - box.min.y, 3) + " x " + fixed(box.max.z - box.min.z, 3) +
                    " " + unit + "; nothing is written: see " + options +
                    (lengths.is_known() ? "" : ", and " + input.unit_option + " for the unit")};
}

void warn_of_sizes(const Console& console, const std::string& reference, const jalon_box& a,
                   const std::string& other, const jalon_box& b) {
  const double decades = std::log10(diagonal(b) / diagonal(a));
  const double power = std::round(std::abs(decades));
  if (!std::isfinite(decades) || power < 1 ||
      std::abs(std::abs(decades) - power) > kFactorTolerance)
    return;
  console.warn((decades > 0 ? other : reference) + " is about " +
               grouped(static_cast<uint64_t>(std::pow(10, power))) + " times as large as " +
               (decades > 0 ? reference : other) + ": are they in one unit?");
}

jalon_box box_of(const Cloud& cloud) {
  jalon_box box{};
  if (count_of(cloud) > 0) must(jalon_cloud_bounds(cloud.get(), &box));
  return box;
}

jalon_box box_of(const Model& model) {
  Fields fields;
  must(jalon_model_vertices(model.get(), Out(fields)));
  uint64_t count = 0;
  const double* xyz = values<double>(fields, "xyz", &count);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  jalon_box box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  for (uint64_t i = 0; i < count; ++i, xyz += 3) {
    box.min = {std::min(box.min.x, xyz[0]), std::min(box.min.y, xyz[1]),
               std::min(box.min.z, xyz[2])};
    box.max = {std::max(box.max.x, xyz[0]), std::max(box.max.y, xyz[1]),
               std::max(box.max.z, xyz[2])};
  }
  return box;
}

}  // namespace jalon::cli
