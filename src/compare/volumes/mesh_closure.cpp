// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/volumes/mesh_closure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <vector>

#include "base/buffer.h"
#include "base/parallel.h"
#include "spatial/partition.h"

namespace jalon {

namespace {

constexpr size_t kBins = 1024;
constexpr size_t kMeshClosureGrain = 1 << 15;

uint64_t mixed(uint64_t z) {  // splitmix64's finaliser (Steele, Lea & Flood 2014)
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

size_t bin_of(const Vec3& p) {
  uint64_t z = 0;
  for (int a = 0; a < 3; ++a) z = mixed(z + std::bit_cast<uint64_t>(p[a] + 0.0));  // -0 is 0
  return z % kBins;
}

/// For each vertex the least one with its coordinates.
Buffer<uint32_t> merged(std::span<const Vec3> vertices, Task& task) {
  Buffer<uint32_t> order(vertices.size()), least(vertices.size());
  const auto begins = partition(
      vertices.size(), kBins, [&](uint32_t v) { return bin_of(vertices[v]); }, task, order.data(),
      [](size_t i) { return static_cast<uint32_t>(i); });
  parallel_chunks(task, kBins, [&](size_t bin) {
    const auto first = order.begin() + begins[bin], last = order.begin() + begins[bin + 1];
    const auto key = [&](uint32_t v) {
      return std::tuple(vertices[v].x, vertices[v].y, vertices[v].z, v);
    };
    std::sort(first, last, [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
    for (auto v = first; v != last; ++v)
      least[*v] = v != first && vertices[*v] == vertices[*(v - 1)] ? least[*(v - 1)] : *v;
  });
  return least;
}

/// A side of a triangle: from the lower to the higher vertex, or back.
struct Side {
  uint32_t low, high;
  int32_t direction;
};

MeshClosure count_sides(Side* first, Side* last) {
  const auto is_less = [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  };
  std::sort(first, last, is_less);
  MeshClosure out;
  for (const Side* run = first; run != last;) {
    const Side* end = run;
    int64_t balance = 0;
    for (; end != last && end->low == run->low && end->high == run->high; ++end)
      balance += end->direction;
    if ((end - run) % 2 != 0) ++out.border_sides;
    else if (balance != 0) ++out.inconsistent_sides;
    run = end;
  }
  return out;
}

}  // namespace

MeshClosure closure_of(std::span<const Vec3> vertices,
                       std::span<const std::array<uint32_t, 3>> triangles, Task& task) {
  const Buffer<uint32_t> least = merged(vertices, task);
  const auto side = [&](size_t i) {
    const auto& t = triangles[i / 3];
    const uint32_t from = least[t[i % 3]], to = least[t[(i + 1) % 3]],
                   other = least[t[(i + 2) % 3]];
    if (from == to || to == other || other == from) return Side{0, 0, 0};
    return from < to ? Side{from, to, 1} : Side{to, from, -1};
  };
  Buffer<Side> sides(3 * triangles.size());
  const auto begins = partition(
      sides.size(), kBins + 1,
      [](const Side& s) { return s.direction == 0 ? kBins : mixed(s.low) % kBins; }, task,
      sides.data(), side);
  std::vector<MeshClosure> parts(kBins);
  parallel_chunks(task, kBins, [&](size_t bin) {
    parts[bin] = count_sides(sides.data() + begins[bin], sides.data() + begins[bin + 1]);
  });
  MeshClosure out;
  for (const MeshClosure& part : parts) {
    out.border_sides += part.border_sides;
    out.inconsistent_sides += part.inconsistent_sides;
  }
  return out;
}

double enclosed_volume(std::span<const Vec3> vertices,
                       std::span<const std::array<uint32_t, 3>> triangles, Task& task) {
  if (triangles.empty()) return 0;
  // About a corner of the surface: map coordinates lose nothing.
  const Vec3 origin = vertices[triangles[0][0]];
  return parallel_reduce(
      task, triangles.size(), kMeshClosureGrain, 0.0, [&](size_t begin, size_t end) {
        double sum = 0;
        for (size_t i = begin; i < end; ++i) {
          const auto& [a, b, c] = triangles[i];
          sum += dot(vertices[a] - origin, cross(vertices[b] - origin, vertices[c] - origin)) / 6;
        }
        return sum;
      });
}

}  // namespace jalon
