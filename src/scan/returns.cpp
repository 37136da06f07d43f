// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/returns.h"

#include <algorithm>

#include "base/buffer.h"

namespace jalon {

namespace {

constexpr size_t kCheckEvery = 64;  // chunks

uint64_t lot(const RayStreams& streams, size_t station, uint64_t ray) {
  RandomStream random = streams.thinning(station, ray);
  random.bits();  // the first draw is the spacing's
  return random.bits();
}

/// f(station, first ray of the chunk, chunk) in their order.
template <class F>
void for_each_chunk(std::vector<Returns>& stations, Task& task, F&& f) {
  for (size_t s = 0; s < stations.size(); ++s)
    for (size_t c = 0; c < stations[s].size(); ++c) {
      if (c % kCheckEvery == 0)
        task.checkpoint(static_cast<double>(s) / static_cast<double>(stations.size()));
      f(s, c * kRayGrain, stations[s][c]);
    }
}

}  // namespace

void thin(std::vector<Returns>& stations, uint64_t max_points, const RayStreams& streams,
          Task& task) {
  size_t n = 0;
  for (const Returns& station : stations)
    for (const auto& chunk : station) n += chunk.size();
  if (max_points == 0 || n <= max_points) return;

  // 1. Every return draws a lot; the max_points lowest stay.
  Buffer<uint64_t> lots(n);
  uint64_t* next = lots.data();
  for_each_chunk(stations, task,
                 [&](size_t station, uint64_t first_ray, const std::vector<Return>& chunk) {
                   for (const Return& r : chunk)
                     *next++ = lot(streams, station, first_ray + (r.ray & kRayMask));
                 });
  uint64_t* const last = lots.data() + (max_points - 1);
  std::nth_element(lots.begin(), last, lots.end());
  const uint64_t limit = *last;
  // 2. Of equal lots the earlier rays stay.
  auto ties = static_cast<uint64_t>(std::count(lots.begin(), last + 1, limit));
  for_each_chunk(stations, task,
                 [&](size_t station, uint64_t first_ray, std::vector<Return>& chunk) {
                   std::erase_if(chunk, [&](const Return& r) {
                     const uint64_t drawn = lot(streams, station, first_ray + (r.ray & kRayMask));
                     if (drawn != limit) return drawn > limit;
                     if (ties == 0) return true;
                     --ties;
                     return false;
                   });
                 });
}

}  // namespace jalon
