// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "formats/trajectory/sbet.h"
#include "formats/trajectory/trajectory_files.h"
#include "unit/formats/fixtures.h"

namespace jalon::test {

constexpr double kDegreeOf = std::numbers::pi / 180;
using SbetLine = std::array<double, kSbetFields>;
using SmrmsgLine = std::array<double, kSmrmsgFields>;

/// 100 Hz northwards through Paris at 10 m/s, the heading seen from a frame that wanders.
inline std::vector<SbetLine> northwards(size_t records) {
  std::vector<SbetLine> made(records);
  for (size_t i = 0; i < records; ++i) {
    SbetLine& r = made[i];
    r.fill(0);
    r[kSbetTime] = 345600 + 0.01 * static_cast<double>(i);
    r[kSbetLatitude] = 48.85 * kDegreeOf + 0.1 * static_cast<double>(i) / 6361000;
    r[kSbetLongitude] = 2.35 * kDegreeOf;
    r[kSbetAltitude] = 80;
    r[kSbetRoll] = 0.01, r[kSbetPitch] = -0.02;
    r[kSbetWanderAngle] = 0.3;
    r[kSbetHeading] = 0.3;                 // true: 0
    r[kSbetAccelerationX] = std::nan("");  // nobody asks for it
  }
  return made;
}

inline std::vector<SmrmsgLine> sigma_lines(double first_s, size_t seconds) {
  std::vector<SmrmsgLine> made;
  for (size_t i = 0; i < seconds; ++i)
    made.push_back({first_s + static_cast<double>(i), 0.02 + 0.01 * static_cast<double>(i), 0.03,
                    0.05, 0.005, 0.006, 0.007, 0.3, 0.3, 1.2});
  return made;
}

template <size_t N>
std::string bytes_of(const std::vector<std::array<double, N>>& lines) {
  std::string bytes(lines.size() * 8 * N, '\0');
  if (!lines.empty()) std::memcpy(bytes.data(), lines.data(), bytes.size());
  return bytes;
}

inline std::string refusal_of_reading(const std::string& path, const std::string& sigmas = "",
                                      const TrajectoryFileSettings& settings = {}) {
  Task task;
  try {
    read_trajectory(path, sigmas, settings, task);
  } catch (const Error& error) {
    const std::string text = error.what();
    return text.substr(text.find(": ") + 2);
  }
  return "";
}

}  // namespace jalon::test
