// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "street_las.h"
#include "street_points.h"

namespace bench {

/// What a terrestrial scanner with a camera tells of the street's points: intensity and colour are of the surface,
/// with noise of their own, time goes on with the order of scanning, angle and source are the scanner's.
class SeenAttributes {
 public:
  SeenAttributes(const Street& street, uint64_t seed) : street_(street), seed_(seed) {}

  /// Of the i-th point in scan order.
  Attributes of(const Sample& sample, size_t i) const {
    constexpr double kPulse_s = 1e-6;            // a million pulses a second
    constexpr double kMostCounts = 4095;         // a receiver of 12 bits
    constexpr double kIntensityNoise = 0.03;     // of itself: speckle
    constexpr double kPixelNoise_levels = 2;     // of 255, of each colour
    constexpr double kPatch_m = 0.1;             // of plaster and paving whose brightness is one
    constexpr double kPatchContrast_levels = 8;  // standard deviation
    Random noise(seed_ ^ i * 0x9E3779B97F4A7C15u);
    const Vec p = sample.point;
    const size_t scanner =
        dot(p - kScanners[0], p - kScanners[0]) <= dot(p - kScanners[1], p - kScanners[1]) ? 0 : 1;
    const Vec w = p - kScanners[scanner];
    const bool is_stray = sample.surface == kOutlier;
    Random paint(0x5eed ^ (is_stray ? 0 : material(sample.surface)));
    Attributes seen;
    seen.time_s = 100000.0 + kPulse_s * static_cast<double>(i);
    seen.source = static_cast<uint16_t>(1 + scanner);
    seen.scan_angle_deg = static_cast<int8_t>(
        std::lround(std::atan2(w.z, std::hypot(w.x, w.y)) * 180 / std::numbers::pi));
    seen.classification = is_stray ? 7 : sample.surface == 0 ? 2 : 6;
    const double reflectance = (0.2 + 0.6 * paint.uniform()) * (is_stray ? 0.3 : cosine(sample, w));
    seen.intensity = static_cast<uint16_t>(std::clamp(
        kMostCounts * reflectance * (1 + kIntensityNoise * noise.normal()), 0.0, kMostCounts));
    Random patch(cell(p.x / kPatch_m) ^ cell(p.y / kPatch_m) << 20 ^ cell(p.z / kPatch_m) << 40);
    const double brightness = kPatchContrast_levels * patch.normal();
    for (uint16_t& level : seen.rgb) {
      const double mean = 60 + 140 * paint.uniform() + brightness;
      level = static_cast<uint16_t>(
          256 * std::lround(std::clamp(mean + kPixelNoise_levels * noise.normal(), 0.0, 255.0)));
    }
    return seen;
  }

 private:
  static uint64_t cell(double place) {
    return static_cast<uint64_t>(static_cast<int64_t>(std::floor(place)));
  }
  uint64_t material(uint32_t surface) const {
    const Surface& s = street_.surfaces[surface];
    return s.plane != 0 ? s.plane : 1000 + surface;
  }
  /// Of the angle of incidence; curved surfaces as if seen head on.
  double cosine(const Sample& sample, Vec w) const {
    const Surface& s = street_.surfaces[sample.surface];
    if (s.shape != Shape::rectangle) return 1;
    return std::fabs(dot(cross(s.u, s.v), w)) / std::sqrt(dot(w, w));
  }

  const Street& street_;
  uint64_t seed_;
};

}  // namespace bench
