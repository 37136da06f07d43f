// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/returns.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace jalon;

namespace {

/// Stations of full chunks, but for the last.
std::vector<Returns> stations_of(std::initializer_list<size_t> counts) {
  std::vector<Returns> out;
  for (const size_t n : counts) {
    out.emplace_back();
    for (size_t i = 0; i < n; ++i) {
      if (i % kRayGrain == 0) out.back().emplace_back();
      const auto ray = static_cast<uint32_t>(i % kRayGrain);
      out.back().back().push_back({static_cast<double>(i), 0, ray | (i % 3 == 0 ? kMixedBit : 0)});
    }
  }
  return out;
}

/// (station, ray) of all that is left, in their order.
std::vector<std::pair<size_t, size_t>> rays(const std::vector<Returns>& stations) {
  std::vector<std::pair<size_t, size_t>> out;
  for (size_t s = 0; s < stations.size(); ++s)
    for (const auto& chunk : stations[s])
      for (const Return& r : chunk) out.push_back({s, static_cast<size_t>(r.range)});
  return out;
}

std::vector<std::pair<size_t, size_t>> thinned(uint64_t most, uint64_t seed) {
  auto stations = stations_of({kRayGrain + 100, 3000});
  Task task;
  thin(stations, most, RayStreams(seed), task);
  return rays(stations);
}

}  // namespace

TEST_CASE("returns__thinned_are_exactly_as_many_as_asked_for_in_their_order") {
  const size_t n = kRayGrain + 3100;
  for (const uint64_t most : {uint64_t{1}, uint64_t{1000}, uint64_t{n - 1}}) {
    const auto left = thinned(most, 1);
    CHECK(left.size() == most);
    CHECK(std::is_sorted(left.begin(), left.end()));
    CHECK(std::adjacent_find(left.begin(), left.end()) == left.end());
  }
}

TEST_CASE("returns__are_all_kept_where_there_are_no_more_than_asked_for_and_with_zero") {
  const size_t n = kRayGrain + 3100;
  CHECK(thinned(0, 1).size() == n);
  CHECK(thinned(n, 1).size() == n);
  CHECK(thinned(n + 1, 1).size() == n);
  std::vector<Returns> none;
  Task task;
  thin(none, 5, RayStreams(1), task);
  CHECK(none.empty());
}

TEST_CASE("returns__fewer_are_a_part_of_more_and_another_seed_leaves_others") {
  const auto few = thinned(500, 1), more = thinned(2000, 1), others = thinned(500, 2);
  CHECK(std::includes(more.begin(), more.end(), few.begin(), few.end()));
  CHECK(few != others);
  // Both stations keep their share: 3000 of 19484 rays are the second's; five standard deviations.
  const auto second = std::count_if(more.begin(), more.end(), [](auto& r) { return r.first == 1; });
  const double p = 3000.0 / (kRayGrain + 3100);
  CHECK(std::abs(static_cast<double>(second) - 2000 * p) < 5 * std::sqrt(2000 * p * (1 - p)));
}

TEST_CASE("returns__streams_differ_by_purpose_station_and_ray_and_repeat") {
  const RayStreams streams(9);
  std::set<uint64_t> drawn;
  for (const size_t station : {size_t{0}, size_t{1}, kMaxStations - 1})
    for (const uint64_t ray : {uint64_t{0}, uint64_t{1}, uint64_t{1} << 35}) {
      for (RandomStream s : {streams.decisions(station, ray), streams.noise(station, ray),
                             streams.panes(station, ray), streams.thinning(station, ray)})
        drawn.insert(s.bits());
      CHECK(streams.noise(station, ray).bits() == RayStreams(9).noise(station, ray).bits());
    }
  CHECK(drawn.size() == 3 * 3 * 4);
}
