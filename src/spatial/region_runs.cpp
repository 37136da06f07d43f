// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/region_runs.h"

#include <cstring>

#include "spatial/union_find.h"

namespace jalon {

namespace {

// The first pixel from `at` on that is occupied, or end.
size_t next_occupied(const uint8_t* pixels, size_t at, size_t end) {
  uint64_t eight = 0;
  while (at + sizeof eight <= end) {
    std::memcpy(&eight, pixels + at, sizeof eight);
    if (eight != 0) break;
    at += sizeof eight;
  }
  while (at < end && pixels[at] == 0) ++at;
  return at;
}

size_t next_empty(const uint8_t* pixels, size_t at, size_t end) {
  const void* found = std::memchr(pixels + at, 0, end - at);
  return found != nullptr ? static_cast<size_t>(static_cast<const uint8_t*>(found) - pixels) : end;
}

// Stretches of occupied pixels, row by row; returns the number of the first one of each row, with the end behind.
std::vector<size_t> find_runs(const Raster& raster, std::vector<RegionRuns::Run>& runs) {
  std::vector<size_t> firsts;
  firsts.reserve(size_t{raster.rows} + 1);
  const uint8_t* pixels = raster.pixels.data();
  for (size_t row = 0; row < raster.rows; ++row) {
    firsts.push_back(runs.size());
    const size_t end = (row + 1) * raster.columns;
    for (size_t at = next_occupied(pixels, row * raster.columns, end); at < end;) {
      const size_t behind = next_empty(pixels, at, end);
      runs.push_back({static_cast<uint32_t>(at), static_cast<uint32_t>(behind), 0});
      at = next_occupied(pixels, behind, end);
    }
  }
  firsts.push_back(runs.size());
  return firsts;
}

// First pass: each stretch joins those of the row before that it touches; both rows are walked once.
UnionFind join_rows(const Raster& raster, const std::vector<RegionRuns::Run>& runs,
                    const std::vector<size_t>& firsts, bool diagonal) {
  UnionFind sets(runs.size());
  const uint64_t columns = raster.columns, reach = diagonal ? 1 : 0;
  for (size_t row = 1; row < raster.rows; ++row) {
    size_t above = firsts[row - 1];
    for (size_t own = firsts[row]; own < firsts[row + 1]; ++own) {
      const uint64_t begin = runs[own].begin, end = runs[own].end;
      const auto ends_before = [&] { return runs[above].end + columns + reach <= begin; };
      while (above < firsts[row] && ends_before()) ++above;
      for (size_t k = above; k < firsts[row] && runs[k].begin + columns < end + reach; ++k)
        sets.join(static_cast<uint32_t>(own), static_cast<uint32_t>(k));
    }
  }
  return sets;
}

}  // namespace

RegionRuns region_runs(const Raster& raster, Connectivity2 connectivity) {
  RegionRuns out;
  const std::vector<size_t> firsts = find_runs(raster, out.runs);
  UnionFind sets = join_rows(raster, out.runs, firsts, connectivity == Connectivity2::k8);
  // Second pass: provisional numbers in order of the first pixel, then by falling size. A set's root is its first one.
  std::vector<uint64_t> sizes;
  for (size_t i = 0; i < out.runs.size(); ++i) {
    RegionRuns::Run& run = out.runs[i];
    const uint32_t root = sets.find(static_cast<uint32_t>(i));
    if (root == i) {
      run.label = static_cast<uint32_t>(sizes.size());
      sizes.push_back(0);
    } else {
      run.label = out.runs[root].label;
    }
    sizes[run.label] += run.end - run.begin;
  }
  const std::vector<uint32_t> rank = ranks_by_size(sizes);
  out.pixel_counts.assign(sizes.size() + 1, 0);
  out.pixel_counts[0] = raster.size();
  for (size_t k = 0; k < sizes.size(); ++k) {
    out.pixel_counts[rank[k]] = sizes[k];
    out.pixel_counts[0] -= sizes[k];
  }
  for (RegionRuns::Run& run : out.runs) run.label = rank[run.label];
  return out;
}

}  // namespace jalon
