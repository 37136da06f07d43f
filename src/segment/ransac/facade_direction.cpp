// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The direction of the main facade before any plane is known: the automatic rotation of Boulaassal 2010, 3.4.5.2, whose
// method the text leaves open. Normals of upright cells vote by their points.

#include <array>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/parallel.h"
#include "segment/ransac/orientation_pass.h"
#include "segment/upright.h"

namespace jalon {

namespace {

constexpr size_t kFacadeDirectionPointsPerChunk = 1 << 15;
constexpr size_t kBins = 180;  // one degree each; normals have no sign
constexpr double kHalfWindows_rad[] = {0.087, 0.052,
                                       0.035};  // 5, 3, 2 degrees about the direction so far

struct Votes {
  std::array<uint64_t, kBins> bins{};
  Votes& operator+=(const Votes& b) {
    for (size_t i = 0; i < kBins; ++i) bins[i] += b.bins[i];
    return *this;
  }
};

struct Mean {
  double sum = 0;
  uint64_t count = 0;
  Mean& operator+=(const Mean& b) {
    sum += b.sum;
    count += b.count;
    return *this;
  }
};

// Azimuth of the normal in [0, pi); NaN for what is not upright.
double azimuth(const SegmentScene& scene, size_t position) {
  const float* m = &scene.normals[3 * position];
  if (!(std::fabs(m[2]) <= kWallSine)) return kNaN;
  const double angle = std::atan2(static_cast<double>(m[1]), static_cast<double>(m[0]));
  const double turned = angle < 0 ? angle + std::numbers::pi : angle;
  return turned >= std::numbers::pi ? 0 : turned;
}

// Difference of two azimuths in [-pi / 2, pi / 2].
double turn_between(double a, double b) { return std::remainder(a - b, std::numbers::pi); }

double busiest_azimuth(const SegmentScene& scene, Task& task) {
  constexpr double kBinsPerRad = kBins / std::numbers::pi;
  const Votes votes = parallel_reduce(
      task, scene.size(), kFacadeDirectionPointsPerChunk, Votes{}, [&](size_t begin, size_t end) {
        Votes part;
        for (size_t i = begin; i < end; ++i) {
          const double a = azimuth(scene, i);
          if (!std::isnan(a))
            ++part.bins[std::min(kBins - 1, static_cast<size_t>(a * kBinsPerRad))];
        }
        return part;
      });
  size_t best = 0;
  uint64_t most = 0;
  for (size_t i = 0; i < kBins;
       ++i) {  // a bin with its neighbours: the direction may lie on a border
    const uint64_t sum =
        votes.bins[(i + kBins - 1) % kBins] + votes.bins[i] + votes.bins[(i + 1) % kBins];
    if (sum > most) {
      most = sum;
      best = i;
    }
  }
  return (static_cast<double>(best) + 0.5) / kBinsPerRad;
}

}  // namespace

FacadeAxes facade_axes(const SegmentScene& scene, Task& task) {
  double direction = busiest_azimuth(scene, task);
  for (const double window : kHalfWindows_rad) {
    const Mean mean = parallel_reduce(
        task, scene.size(), kFacadeDirectionPointsPerChunk, Mean{}, [&](size_t begin, size_t end) {
          Mean part;
          for (size_t i = begin; i < end; ++i) {
            const double turn = turn_between(azimuth(scene, i), direction);
            if (std::fabs(turn) <= window) part += Mean{turn, 1};
          }
          return part;
        });
    if (mean.count != 0) direction += mean.sum / static_cast<double>(mean.count);
  }
  return FacadeAxes::of({std::cos(direction), std::sin(direction), 0});
}

}  // namespace jalon
