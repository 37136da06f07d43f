// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"
#include "base/task.h"
#include "scan/directions.h"

namespace jalon {

constexpr size_t kRayGrain = 16384;  ///< rays a chunk: about 5 ms
constexpr size_t kMaxStations = size_t{1}
                                << 26;  ///< (station, ray) is a random stream number of 64 bits

/// One return, before noise: small, because all of a scan's are kept until their number is known.
struct Return {
  double range;
  uint32_t triangle;
  uint32_t ray;  ///< in its chunk; the top bits mark what is no point of one plane
};
constexpr uint32_t kOutlierBit = 1u << 31, kMixedBit = 1u << 30, kRayMask = kMixedBit - 1;

/// Returns of a station, chunk by chunk of its rays.
using Returns = std::vector<std::vector<Return>>;

/// The random streams of a ray: pure functions of (seed, station, ray), so that threads may take rays in any order.
/// One decides what comes back, one is the noise, one decides at panes of glass, one thins: changing one changes
/// nothing of the others.
class RayStreams {
 public:
  explicit RayStreams(uint64_t seed) : seed_(seed) {}
  RandomStream decisions(size_t station, uint64_t ray) const { return stream(station, ray, 0); }
  RandomStream noise(size_t station, uint64_t ray) const { return stream(station, ray, 1); }
  RandomStream panes(size_t station, uint64_t ray) const { return stream(station, ray, 2); }
  RandomStream thinning(size_t station, uint64_t ray) const { return stream(station, ray, 3); }

 private:
  static constexpr int kRayBits = 37;
  static_assert(2 * kMaxRays <= double{size_t{1} << kRayBits});
  RandomStream stream(size_t station, uint64_t ray, uint64_t which) const {
    return {seed_, (station << kRayBits | (which & 2) << (kRayBits - 2) | ray) * 2 + (which & 1)};
  }
  uint64_t seed_;
};

/// Drops returns at random until this many are left, of all stations together; none when there are fewer.
void thin(std::vector<Returns>& stations, uint64_t max_points, const RayStreams& streams,
          Task& task);

}  // namespace jalon
