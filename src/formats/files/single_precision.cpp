// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/single_precision.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string>
#include <vector>

#include "formats/files/number_text.h"

namespace jalon {

namespace {

constexpr size_t kPrecisionSamples = 4096;
// Fewer numbers may use the last bit by chance. Of rounded ones half do; of whole metres none.
constexpr size_t kLeastOfPrecision = 64;
constexpr double kLeastShareOfOdd = 0.25;
// What a survey notices: a millimetre, and a 50 000th of the scan, for the unit may be another than the metre.
constexpr double kLeastStep = 0.001, kLeastStepOfScan = 2e-5;

std::vector<double> sampled(const Cloud& cloud, size_t axis) {
  const size_t step = (cloud.size() + kPrecisionSamples - 1) / kPrecisionSamples;
  std::vector<double> out;
  for (size_t i = 0; i < cloud.size(); i += step) out.push_back(cloud.xyz()[3 * i + axis]);
  return out;
}

double step_of(const std::vector<double>& values) {
  std::vector<double> sizes;
  for (const double value : values) {
    if (static_cast<double>(static_cast<float>(value)) != value) return 0;
    sizes.push_back(std::fabs(value));
  }
  if (sizes.size() < kLeastOfPrecision) return 0;
  const auto middle = sizes.begin() + static_cast<ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  if (*middle < static_cast<double>(FLT_MIN)) return 0;
  const double step = std::ldexp(1, std::ilogb(*middle) - (FLT_MANT_DIG - 1));
  size_t of_step = 0, odd = 0;
  for (const double size : sizes) {
    if (size == 0 || std::ilogb(size) != std::ilogb(*middle)) continue;
    ++of_step;
    odd += std::fmod(size / step, 2) == 1 ? 1 : 0;
  }
  const bool uses_last_bit =
      static_cast<double>(odd) >= kLeastShareOfOdd * static_cast<double>(of_step);
  return uses_last_bit ? step : 0;
}

}  // namespace

std::array<double, 3> single_precision_steps(const Cloud& cloud) {
  std::array<double, 3> out{};
  for (size_t axis = 0; axis < 3 && cloud.size() > 0; ++axis)
    out[axis] = step_of(sampled(cloud, axis));
  return out;
}

void warn_of_single_precision(const Cloud& cloud, const std::string& path, Task& task) {
  const std::array<double, 3> steps = single_precision_steps(cloud);
  if (*std::ranges::max_element(steps) < kLeastStep) return;
  double scan = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    const std::vector<double> values = sampled(cloud, axis);
    const auto [least, most] = std::ranges::minmax(values);
    scan = std::hypot(scan, most - least);
  }
  std::string told;
  for (size_t axis = 0; axis < 3; ++axis) {
    if (steps[axis] < std::max(kLeastStep, kLeastStepOfScan * scan)) continue;
    told += told.empty() ? "" : ", ";
    told += "xyz"[axis];
    told += " to steps of ";
    append_number(told, steps[axis]);
  }
  if (told.empty()) return;
  task.log(Task::kWarning,
           "%s: coordinates of single precision, so far from the origin rounded: %s; what is "
           "smaller is lost: export them as doubles, or from an origin near the scan",
           path.c_str(), told.c_str());
}

}  // namespace jalon
