// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/shared_edges.h"

#include <algorithm>
#include <bit>

#include "base/error.h"
#include "spatial/partition.h"

namespace jalon {

namespace {

constexpr size_t kEdgesPerBin = 4096;  // sorted in about 0.2 ms
constexpr size_t kSharedEdgesMostBins = 1 << 13;
constexpr size_t kJoinsPerCheck = 1 << 16;

/// An edge under a hash of its two ends, whichever comes first.
struct Edge {
  uint64_t key;
  uint32_t number;  ///< 3 x triangle + corner it starts at
};

uint64_t mixed(uint64_t z) {  // splitmix64's finaliser (Steele, Lea & Flood 2014)
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

uint64_t hash(const Vec3& p) {
  uint64_t h = 0;
  for (int a = 0; a < 3; ++a)
    h = mixed(h * 0x9E3779B97F4A7C15ull + std::bit_cast<uint64_t>(p[a] + 0.0));
  return h;
}

/// A pair of edges of two triangles that are to be joined.
struct Join {
  uint32_t a, b;
  bool is_inner;  ///< one triangle on either side of the edge
};

bool are_one(const FlatTriangles& flats, uint32_t a, uint32_t b) {
  const Vec3 a0 = flats.corner(a / 3, a % 3), a1 = flats.corner(a / 3, a % 3 + 1);
  const Vec3 b0 = flats.corner(b / 3, b % 3), b1 = flats.corner(b / 3, b % 3 + 1);
  return (a0 == b0 && a1 == b1) || (a0 == b1 && a1 == b0);
}

/// Two-sided faces have both triangles on the same side: their edge is still a border.
bool are_either_side(const FlatTriangles& flats, uint32_t a, uint32_t b) {
  const Vec3 from = flats.corner(a / 3, a % 3),
             across = cross(flats.corner(a / 3, a % 3 + 1) - from, flats.plane(a / 3).normal);
  return dot(flats.corner(a / 3, a % 3 + 2) - from, across) *
             dot(flats.corner(b / 3, b % 3 + 2) - from, across) <
         0;
}

/// Every edge of a run of equal keys is joined to the first before it that is the same edge of a coplanar triangle.
void join_run(const FlatTriangles& flats, const Edge* begin, const Edge* end, const Task& task,
              std::vector<Join>& joins) {
  std::vector<uint32_t> distinct{begin->number};
  for (const Edge* e = begin + 1; e != end && !task.cancelled(); ++e) {
    const auto same = std::find_if(distinct.begin(), distinct.end(), [&](uint32_t d) {
      return flats.are_coplanar(d / 3, e->number / 3) && are_one(flats, d, e->number);
    });
    if (same != distinct.end())
      joins.push_back({*same, e->number, are_either_side(flats, *same, e->number)});
    else distinct.push_back(e->number);
  }
}

}  // namespace

std::vector<uint8_t> join_by_edges(const FlatTriangles& flats, UnionFind& groups, Task& task) {
  const size_t n = 3 * size_t{flats.size()};
  std::vector<uint8_t> inner(flats.size(), 0);
  if (n == 0) return inner;
  if (n > 0xffffffffu)
    fail(Status::kLimit, "the true planes of at most 1 431 655 765 triangles can be found");

  // 1. Equal edges into the same bin.
  const size_t bins = std::bit_floor(std::clamp<size_t>(n / kEdgesPerBin, 1, kSharedEdgesMostBins));
  Buffer<Edge> edges(n);
  std::vector<size_t> begins;
  {
    const ProgressSpan span(task, 0, 0.5);
    begins = partition(
        n, bins, [&](const Edge& e) { return e.key & (bins - 1); }, task, edges.data(),
        [&](size_t i) {
          const auto t = static_cast<uint32_t>(i / 3);
          return Edge{hash(flats.corner(t, i % 3)) + hash(flats.corner(t, i % 3 + 1)),
                      static_cast<uint32_t>(i)};
        });
  }
  // 2. Sorted, they lie side by side.
  std::vector<std::vector<Join>> joins(bins);
  {
    const ProgressSpan span(task, 0.5, 0.9);
    parallel_chunks(task, bins, [&](size_t bin) {
      Edge* const first = edges.data() + begins[bin];
      Edge* const last = std::remove_if(first, edges.data() + begins[bin + 1], [&](const Edge& e) {
        return !flats.is_flat(e.number / 3);
      });
      std::sort(first, last, [](const Edge& a, const Edge& b) {
        return a.key != b.key ? a.key < b.key : a.number < b.number;
      });
      for (Edge *run = first, *next; run != last; run = next) {
        next = std::find_if(run, last, [&](const Edge& e) { return e.key != run->key; });
        join_run(flats, run, next, task, joins[bin]);
      }
    });
  }
  // 3. The order of joins does not matter: the smallest triangle is the root.
  size_t joined = 0;
  for (size_t bin = 0; bin < bins; ++bin)
    for (const Join& join : joins[bin]) {
      if (joined++ % kJoinsPerCheck == 0)
        task.checkpoint(0.9 + 0.1 * static_cast<double>(bin) / static_cast<double>(bins));
      groups.join(join.a / 3, join.b / 3);
      if (!join.is_inner) continue;
      for (const uint32_t e : {join.a, join.b}) inner[e / 3] |= static_cast<uint8_t>(1u << (e % 3));
    }
  return inner;
}

}  // namespace jalon
