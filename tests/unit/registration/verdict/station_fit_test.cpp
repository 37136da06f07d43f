// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/station_fit.h"

#include <doctest/doctest.h>

#include "unit/registration/verdict/judged_rooms.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::vector<DensityPlace> density_of(const JudgedScan& scan) {
  std::vector<DensityPlace> out;
  for (const Surfel& s : scan.judged.surfels) out.push_back({s.place, s.normal, s.radius_m});
  return out;
}

}  // namespace

TEST_CASE("station_fit__finds_the_standpoint_by_the_density_of_the_points") {
  Task task;
  for (const uint64_t seed : {1, 2, 3}) {
    for (const PairScene& scene :
         {furnished(seed, seed), crossing(seed), corridor_with_doors(seed, seed)}) {
      const auto scan = judged_scan(scene, 0, seed);
      const StationFit fit = fit_station(density_of(*scan), Spreading::kEvenAngles, task);
      CHECK(norm(fit.place - scan->station) < 0.5);
    }
  }
}

TEST_CASE("station_fit__gives_none_from_a_few_surfels") {
  Task task;
  const std::vector<DensityPlace> few(10, DensityPlace{{1, 2, 3}, {0, 0, 1}, 0.1});
  CHECK_FALSE(std::isfinite(fit_station(few, Spreading::kEvenDirections, task).spread));
}

TEST_CASE("station_fit__finds_a_standpoint_outside_of_what_was_scanned") {
  Task task;
  for (const uint64_t seed : {1, 2, 3}) {
    const auto scan = judged_scan(thing(seed), 0, seed);  // from 6 m, some 2 m across
    const StationFit fit = fit_station(density_of(*scan), Spreading::kEvenAngles, task);
    CHECK(norm(fit.place - scan->station) < 1.5);
  }
}
