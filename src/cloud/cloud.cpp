// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/cloud.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr size_t kCloudGrain = 1 << 16;                    // points a chunk: 1.5 MB, about 0.2 ms
constexpr uint64_t kExponentBits = 0x7ff0000000000000ull;  // all set in infinities and NaNs only

/// Integer compares, which the compiler turns into vector code.
bool any_not_finite(std::span<const double> values) {
  uint64_t found = 0;
  for (const double value : values)
    found |= (std::bit_cast<uint64_t>(value) & kExponentBits) == kExponentBits;
  return found != 0;
}

}  // namespace

Cloud make_cloud(Buffer<double> xyz) {
  Cloud cloud;
  cloud.xyz_buffer = std::make_shared<const Buffer<double>>(std::move(xyz));
  return cloud;
}

void require_finite(std::span<const double> xyz) {
  constexpr size_t kBlock = 3 * 4096;
  for (size_t begin = 0; begin < xyz.size(); begin += kBlock) {
    const size_t end = std::min(xyz.size(), begin + kBlock);
    if (!any_not_finite(xyz.subspan(begin, end - begin))) continue;
    for (size_t i = begin; i < end; ++i)
      if (!std::isfinite(xyz[i]))
        fail(Status::kInvalidArgument, "point %llu: %c is %s, not a finite number",
             static_cast<unsigned long long>(i / 3), "xyz"[i % 3], text_of(xyz[i]).c_str());
  }
}

Box3 bounds(const Cloud& cloud, Task& task) {
  return parallel_reduce(task, cloud.size(), kCloudGrain, Box3{}, [&](size_t begin, size_t end) {
    Box3 box;
    for (size_t i = begin; i < end; ++i) box.add(cloud.point(i));
    return box;
  });
}

const Station* station_of(const Cloud& cloud, uint64_t i) {
  // Stations follow each other in the order of their points; the last one that begins at or before i is the candidate.
  auto after = std::upper_bound(
      cloud.stations.begin(), cloud.stations.end(), i,
      [](uint64_t point, const Station& station) { return point < station.first; });
  while (after != cloud.stations.begin()) {
    const Station& station = *--after;
    if (station.count == 0) continue;
    return i - station.first < station.count ? &station : nullptr;
  }
  return nullptr;
}

}  // namespace jalon
