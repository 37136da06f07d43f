// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/region_runs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "base/random.h"

using namespace jalon;

namespace {

Raster noise(uint32_t columns, uint32_t rows, double share, uint64_t seed) {
  RandomStream random(seed, 0);
  Raster raster;
  raster.columns = columns;
  raster.rows = rows;
  for (size_t i = 0; i < size_t{columns} * rows; ++i)
    raster.pixels.push_back(random.uniform() < share);
  return raster;
}

// The definition: every pixel takes the least number of its neighbours until none changes.
std::vector<uint32_t> sets_by_definition(const Raster& raster, bool diagonal) {
  const auto columns = static_cast<int64_t>(raster.columns), rows = int64_t{raster.rows};
  std::vector<uint32_t> sets(raster.size());
  for (size_t i = 0; i < sets.size(); ++i) sets[i] = static_cast<uint32_t>(i);
  for (bool changed = true; changed;) {
    changed = false;
    for (int64_t at = 0; at < columns * rows; ++at)
      for (int64_t dy = -1; dy <= 1; ++dy)
        for (int64_t dx = -1; dx <= 1; ++dx) {
          const int64_t x = at % columns + dx, y = at / columns + dy;
          if ((!diagonal && dx != 0 && dy != 0) || x < 0 || y < 0 || x >= columns || y >= rows)
            continue;
          const auto a = static_cast<size_t>(at), b = static_cast<size_t>(y * columns + x);
          if (raster.pixels[a] == 0 || raster.pixels[b] == 0 || sets[a] <= sets[b]) continue;
          sets[a] = sets[b];
          changed = true;
        }
  }
  return sets;
}

}  // namespace

TEST_CASE("region_runs__are_the_regions_by_definition") {
  for (const double share : {0.1, 0.4, 0.6, 0.9, 1.0})
    for (const uint32_t columns : {1u, 7u, 40u})
      for (const bool diagonal : {false, true}) {
        CAPTURE(share);
        CAPTURE(columns);
        CAPTURE(diagonal);
        const Raster raster = noise(columns, 23, share, 11 + columns);
        const auto sets = sets_by_definition(raster, diagonal);
        const RegionRuns found =
            region_runs(raster, diagonal ? Connectivity2::k8 : Connectivity2::k4);
        std::vector<uint32_t> labels(raster.size(), 0);
        uint32_t behind = 0;
        for (const RegionRuns::Run& run : found.runs) {
          CHECK(run.begin >= behind);
          CHECK(run.begin / columns == (run.end - 1) / columns);  // of one row
          behind = run.end;
          std::fill_n(labels.begin() + run.begin, run.end - run.begin, run.label);
        }
        std::set<std::pair<uint32_t, uint32_t>> pairs;  // of a label and a set: one to one
        std::vector<uint64_t> counts(found.count() + 1, 0);
        for (size_t i = 0; i < labels.size(); ++i) {
          REQUIRE((labels[i] != 0) == (raster.pixels[i] != 0));
          ++counts[labels[i]];
          if (labels[i] != 0) pairs.insert({labels[i], sets[i]});
        }
        CHECK(pairs.size() == found.count());
        CHECK(counts == found.pixel_counts);
        CHECK(std::is_sorted(counts.rbegin(), counts.rend() - 1));
      }
}

TEST_CASE("region_runs__are_as_few_as_the_stretches_of_an_image") {
  CHECK(region_runs(noise(500, 300, 1.0, 1)).runs.size() == 300);
  CHECK(region_runs(noise(500, 300, 0.0, 1)).runs.empty());
  CHECK(region_runs(Raster{}).count() == 0);
}
