// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/deviation_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/sheet/ticks.h"

namespace jalon {

namespace {

constexpr double kShare = 0.98;
constexpr size_t kSample = 200000;
constexpr double kLeastLimit_m = 1e-4;

constexpr std::array<Rgb, 7> kDiverging = {{{0x21, 0x66, 0xac},
                                            {0x67, 0xa9, 0xcf},
                                            {0xd1, 0xe5, 0xf0},
                                            {0xf0, 0xf0, 0xf0},
                                            {0xfd, 0xdb, 0xc7},
                                            {0xef, 0x8a, 0x62},
                                            {0xb2, 0x18, 0x2b}}};
constexpr std::array<Rgb, 6> kSequential = {{{0xe8, 0xec, 0xd2},
                                             {0xfe, 0xd9, 0x76},
                                             {0xfd, 0x8d, 0x3c},
                                             {0xf0, 0x3b, 0x20},
                                             {0xbd, 0x00, 0x26},
                                             {0x5a, 0x00, 0x1c}}};

template <size_t N>
Rgb between(const std::array<Rgb, N>& stops, double t) {
  const double at = t * static_cast<double>(N - 1);
  const size_t i = std::min(static_cast<size_t>(at), N - 2);
  return mixed(stops[i], stops[i + 1], at - static_cast<double>(i));
}

}  // namespace

Rgb mixed(const Rgb& a, const Rgb& b, double share) {
  const auto of = [&](uint8_t from, uint8_t to) {
    return static_cast<uint8_t>(std::lround(from + share * (to - from)));
  };
  return {of(a.red, b.red), of(a.green, b.green), of(a.blue, b.blue)};
}

Rgb DeviationScale::colour(uint32_t step) const {
  const double t = static_cast<double>(step) / (kSteps - 1);
  return is_signed ? between(kDiverging, t) : between(kSequential, t);
}

uint32_t DeviationScale::step_of(double distance_m) const {
  const double t = (distance_m - lowest_m()) / (limit_m - lowest_m());
  return static_cast<uint32_t>(std::clamp(t * kSteps, 0.0, kSteps - 1.0));
}

DeviationScale deviation_scale(std::span<const Comparison* const> comparisons, double limit_m) {
  DeviationScale out;
  std::vector<double> sizes;
  for (const Comparison* comparison : comparisons) {
    const auto distance = comparison->points.require("distance").values<double>();
    const size_t step = distance.size() / kSample + 1;
    for (size_t i = 0; i < distance.size(); i += step) {
      if (!std::isfinite(distance[i])) continue;
      out.is_signed = out.is_signed || distance[i] < 0;
      sizes.push_back(std::abs(distance[i]));
    }
  }
  out.limit_m = limit_m;
  if (limit_m > 0) return out;
  out.limit_m = 1;
  if (sizes.empty()) return out;
  const auto at =
      sizes.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  out.limit_m = round_up_125(std::max(*at, kLeastLimit_m));
  return out;
}

}  // namespace jalon
