// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/contour/boundary_rings.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/serial.h"

namespace jalon {

namespace {

constexpr uint32_t kNone = 0xffffffffu;
constexpr size_t kHalfEdgesPerLook = 1 << 16;

// Half-edge h = 3 t + k runs from corner k of triangle t to corner k + 1.
uint32_t next_in_triangle(uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

struct HalfEdges {
  std::span<const Triangle2> triangles;
  std::vector<uint32_t> twin;  ///< the same edge in the neighbour, or kNone on the border

  uint32_t from(uint32_t h) const { return triangles[h / 3][h % 3]; }
};

// A bucket for each point: the half-edges of which it is the lesser end, by their other end; a few each.
HalfEdges pair_half_edges(std::span<const Triangle2> triangles, size_t points, Task& task) {
  HalfEdges edges{triangles, std::vector<uint32_t>(3 * triangles.size(), kNone)};
  const auto ends_of = [&](uint32_t h) {
    return std::minmax({edges.from(h), edges.from(next_in_triangle(h))});
  };
  std::vector<uint32_t> bucket_end(points + 1, 0);  // their beginnings until they are filled
  serial_for(task, edges.twin.size(), kHalfEdgesPerLook, [&](size_t begin, size_t end) {
    for (size_t h = begin; h < end; ++h) ++bucket_end[ends_of(static_cast<uint32_t>(h)).first + 1];
  });
  std::partial_sum(bucket_end.begin(), bucket_end.end(), bucket_end.begin());
  std::vector<std::pair<uint32_t, uint32_t>> keyed(edges.twin.size());
  for (uint32_t h = 0; h < keyed.size(); ++h) {
    if (h % kHalfEdgesPerLook == 0) task.checkpoint(0);
    const auto [low, high] = ends_of(h);
    keyed[bucket_end[low]++] = {high, h};
  }
  size_t begin = 0;
  for (size_t p = 0; p < points; begin = bucket_end[p++]) {
    if (p % kHalfEdgesPerLook == 0) task.checkpoint(0);
    std::sort(keyed.data() + begin, keyed.data() + bucket_end[p]);
    for (size_t i = begin + 1; i < bucket_end[p]; ++i)
      if (keyed[i].first == keyed[i - 1].first) {
        edges.twin[keyed[i].second] = keyed[i - 1].second;
        edges.twin[keyed[i - 1].second] = keyed[i].second;
      }
  }
  return edges;
}

// Piece of each triangle, numbered by first triangle; returns how many.
uint32_t label_pieces(const HalfEdges& edges, std::vector<uint32_t>& piece, Task& task) {
  piece.assign(edges.triangles.size(), kNone);
  uint32_t count = 0;
  std::vector<uint32_t> stack;
  size_t labelled = 0;
  for (uint32_t seed = 0; seed < piece.size(); ++seed) {
    if (piece[seed] != kNone) continue;
    piece[seed] = count;
    stack.assign(1, seed);
    while (!stack.empty()) {
      if (labelled++ % kHalfEdgesPerLook == 0) task.checkpoint(0);
      const uint32_t t = stack.back();
      stack.pop_back();
      for (uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const uint32_t other = edges.twin[h];
        if (other == kNone || piece[other / 3] != kNone) continue;
        piece[other / 3] = count;
        stack.push_back(other / 3);
      }
    }
    ++count;
  }
  return count;
}

// The border half-edge after h: turn about h's end through the triangles of one fan. At a point where fans of the same
// piece meet, this keeps to the fan, and split_at_repeats takes the loops apart.
uint32_t next_on_border(const HalfEdges& edges, uint32_t h) {
  uint32_t next = next_in_triangle(h);
  while (edges.twin[next] != kNone) next = next_in_triangle(edges.twin[next]);
  return next;
}

// Cuts a closed walk where it comes back to a point: every loop becomes a ring of its own.
void split_at_repeats(std::span<const uint32_t> walk, std::vector<uint32_t>& position,
                      std::vector<std::vector<uint32_t>>& rings) {
  std::vector<uint32_t> open;
  for (const uint32_t v : walk) {
    if (position[v] != kNone) {
      const uint32_t start = position[v];
      rings.emplace_back(open.begin() + start, open.end());
      for (size_t i = start; i < open.size(); ++i) position[open[i]] = kNone;
      open.resize(start);
    }
    position[v] = static_cast<uint32_t>(open.size());
    open.push_back(v);
  }
  for (const uint32_t v : open) position[v] = kNone;
  if (!open.empty()) rings.push_back(std::move(open));
}

}  // namespace

std::vector<BoundaryPiece> boundary_rings(std::span<const Triangle2> triangles,
                                          std::span<const Vec2> points, Task& task) {
  const HalfEdges edges = pair_half_edges(triangles, points.size(), task);
  std::vector<uint32_t> piece_of;
  std::vector<BoundaryPiece> pieces(label_pieces(edges, piece_of, task));
  serial_for(task, triangles.size(), kHalfEdgesPerLook, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = triangles[t];
      pieces[piece_of[t]].area += 0.5 * cross(points[b] - points[a], points[c] - points[a]);
    }
  });
  std::vector<uint8_t> used(edges.twin.size(), 0);
  std::vector<uint32_t> walk, position(points.size(), kNone);
  for (uint32_t start = 0; start < used.size(); ++start) {
    if (start % kHalfEdgesPerLook == 0) task.checkpoint(0);
    if (edges.twin[start] != kNone || used[start] != 0) continue;
    walk.clear();
    for (uint32_t h = start; used[h] == 0; h = next_on_border(edges, h)) {
      used[h] = 1;
      walk.push_back(edges.from(h));
    }
    split_at_repeats(walk, position, pieces[piece_of[start / 3]].rings);
  }
  return pieces;
}

}  // namespace jalon
