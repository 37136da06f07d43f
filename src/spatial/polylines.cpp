// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/polylines.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace jalon {

namespace {

constexpr int kFilled =
    6;  // of the eight cells about a node: a line has two to four, and a corner five

struct NodeCell {
  int64_t column, row;
  auto operator<=>(const NodeCell&) const = default;
};

// Places so far away share a cell: doubles tell no neighbours apart there, and whole numbers have an end.
constexpr double kFarthestCell = 0x1p60;

int64_t cell_number(double place_m, double cell_m) {
  return static_cast<int64_t>(
      std::clamp(std::floor(place_m / cell_m), -kFarthestCell, kFarthestCell));
}

NodeCell cell_at(const Vec2& p, double cell_m) {
  return {cell_number(p.u, cell_m), cell_number(p.v, cell_m)};
}

double squared_between(const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  return d.u * d.u + d.v * d.v;
}

// Which node stands in a cell: open addressing, half full.
class NodeTable {
 public:
  static constexpr uint32_t kNoNode = 0xffffffffu;

  explicit NodeTable(std::span<const NodeCell> cells)
      : cells_(cells), slots_(std::bit_ceil(2 * cells.size() + 1), kNoNode) {
    for (uint32_t node = 0; node < cells.size(); ++node) {
      size_t slot = slot_of(cells[node]);
      while (slots_[slot] != kNoNode) slot = next(slot);
      slots_[slot] = node;
    }
  }
  uint32_t at(const NodeCell& cell) const {
    size_t slot = slot_of(cell);
    while (slots_[slot] != kNoNode && cells_[slots_[slot]] != cell) slot = next(slot);
    return slots_[slot];
  }

 private:
  size_t next(size_t slot) const { return (slot + 1) & (slots_.size() - 1); }
  // Odd multipliers spread neighbours (Knuth 1998, 6.4); the high bits of the sum are the mixed ones.
  size_t slot_of(const NodeCell& cell) const {
    const uint64_t mixed = static_cast<uint64_t>(cell.column) * 0x9e3779b97f4a7c15ull +
                           static_cast<uint64_t>(cell.row) * 0xc2b2ae3d27d4eb4full;
    return static_cast<size_t>(mixed >> 32) & (slots_.size() - 1);
  }
  std::span<const NodeCell> cells_;
  std::vector<uint32_t> slots_;
};

std::vector<NodeCell> cells_of(std::span<const ProfileNode> nodes, double cell_m) {
  std::vector<NodeCell> cells;
  cells.reserve(nodes.size());
  for (const ProfileNode& node : nodes) cells.push_back(cell_at(node.middle, cell_m));
  return cells;
}

// Walks over nodes that stand in the order of their cells.
class Chainer {
 public:
  Chainer(std::span<const ProfileNode> nodes, double cell_m, double gap_m)
      : nodes_(nodes),
        gap_m_(gap_m),
        cell_m_(cell_m),
        used_(nodes.size(), 0),
        cells_(cells_of(nodes, cell_m)),
        table_(cells_) {}

  std::vector<std::vector<uint32_t>> run() {
    std::vector<std::vector<uint32_t>> chains;
    leave_out_faces();
    for (uint32_t i = 0; i < nodes_.size(); ++i) {
      if (used_[i] != 0) continue;
      used_[i] = 1;
      std::vector<uint32_t> chain = walk(i), back = walk(i);
      std::reverse(back.begin(), back.end());
      back.push_back(i);
      back.insert(back.end(), chain.begin(), chain.end());
      chains.push_back(std::move(back));
    }
    return chains;
  }

 private:
  static constexpr uint32_t kNoNode = NodeTable::kNoNode;

  // Where a surface lies in the slice its nodes fill an area, which has no profile but its edge.
  void leave_out_faces() {
    std::vector<uint8_t> inside(nodes_.size(), 0);
    for (uint32_t i = 0; i < nodes_.size(); ++i) {
      int around = 0;
      for (int64_t c = -1; c <= 1; ++c)
        for (int64_t r = -1; r <= 1; ++r)
          around += (c != 0 || r != 0) && node_at(i, c, r) != kNoNode;
      inside[i] = around >= kFilled;
    }
    used_ = std::move(inside);
  }

  std::vector<uint32_t> walk(uint32_t from) {
    std::vector<uint32_t> chain;
    for (uint32_t next = nearest(from); next != kNoNode; next = nearest(next)) {
      used_[next] = 1;
      chain.push_back(next);
    }
    return chain;
  }

  // Ring by ring of cells: what lies in ring r is at least r - 1 cells away.
  uint32_t nearest(uint32_t from) const {
    const auto rings = static_cast<int64_t>(std::ceil(gap_m_ / cell_m_));
    double best = gap_m_ * gap_m_;
    uint32_t found = kNoNode;
    for (int64_t ring = 1; ring <= rings; ++ring) {
      const double least = static_cast<double>(ring - 1) * cell_m_;
      if (found != kNoNode && least * least > best) break;
      for (int64_t c = -ring; c <= ring; ++c) {
        const bool side = c == -ring || c == ring;
        for (int64_t r = -ring; r <= ring; r += side ? 1 : 2 * ring) look(from, c, r, best, found);
      }
    }
    return found;
  }

  uint32_t node_at(uint32_t from, int64_t columns, int64_t rows) const {
    return table_.at({cells_[from].column + columns, cells_[from].row + rows});
  }

  void look(uint32_t from, int64_t columns, int64_t rows, double& best, uint32_t& found) const {
    const uint32_t node = node_at(from, columns, rows);
    if (node == kNoNode || used_[node] != 0) return;
    const double squared = squared_between(nodes_[from].middle, nodes_[node].middle);
    if (squared < best || (squared == best && node < found)) {
      best = squared;
      found = node;
    }
  }

  std::span<const ProfileNode> nodes_;
  double gap_m_, cell_m_;
  std::vector<uint8_t> used_;
  std::vector<NodeCell> cells_;
  NodeTable table_;
};

// Farthest point strictly between two places from their chord.
uint32_t farthest(std::span<const Vec2> chain, uint32_t from, uint32_t to, double& distance) {
  const Vec2 a = chain[from], chord = chain[to] - a;
  const double length = std::sqrt(squared_between(chain[from], chain[to]));
  uint32_t best = from;
  distance = -1;
  for (uint32_t i = from + 1; i < to; ++i) {
    const Vec2 d = chain[i] - a;
    const double off = length > 0 ? std::fabs(chord.u * d.v - chord.v * d.u) / length
                                  : std::sqrt(squared_between(a, chain[i]));
    if (off > distance) {
      distance = off;
      best = i;
    }
  }
  return best;
}

}  // namespace

std::vector<ProfileNode> thin_points(std::span<const Vec2> points, double cell_m,
                                     std::vector<uint32_t>& order) {
  order.resize(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<NodeCell> cells;
  for (const Vec2& p : points) cells.push_back(cell_at(p, cell_m));
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return cells[a] != cells[b] ? cells[a] < cells[b] : a < b;
  });
  std::vector<ProfileNode> nodes;
  for (uint32_t i = 0; i < order.size();) {
    ProfileNode node{{0, 0}, i, 0};
    const NodeCell own = cells[order[i]];
    for (; i < order.size() && cells[order[i]] == own; ++i) {
      node.middle = node.middle + points[order[i]];
      ++node.count;
    }
    node.middle = node.middle * (1.0 / node.count);
    nodes.push_back(node);
  }
  return nodes;
}

std::vector<uint32_t> fullest_neighbours(std::span<const ProfileNode> nodes, double cell_m) {
  const std::vector<NodeCell> cells = cells_of(nodes, cell_m);
  const NodeTable table(cells);
  std::vector<uint32_t> out(nodes.size());
  for (uint32_t i = 0; i < nodes.size(); ++i) {
    out[i] = i;
    uint32_t most = 0;
    for (int64_t c = -1; c <= 1; ++c)
      for (int64_t r = -1; r <= 1; ++r) {
        const uint32_t other = table.at({cells[i].column + c, cells[i].row + r});
        if (other == NodeTable::kNoNode || other == i || nodes[other].count <= most) continue;
        most = nodes[other].count;
        out[i] = other;
      }
  }
  return out;
}

std::vector<std::vector<uint32_t>> chain_nodes(std::span<const ProfileNode> nodes, double cell_m,
                                               double gap_m) {
  return Chainer(nodes, cell_m, gap_m).run();
}

// With a stack of its own in the place of recursion: a chain may have a million points.
std::vector<uint32_t> simplify(std::span<const Vec2> chain, double tolerance_m) {
  if (chain.size() < 2) return std::vector<uint32_t>(chain.size(), 0);
  const auto last = static_cast<uint32_t>(chain.size() - 1);
  std::vector<uint32_t> kept{0, last};
  std::vector<std::pair<uint32_t, uint32_t>> todo{{0, last}};
  while (!todo.empty()) {
    const auto [from, to] = todo.back();
    todo.pop_back();
    double distance = 0;
    const uint32_t at = farthest(chain, from, to, distance);
    if (at == from || distance <= tolerance_m) continue;
    kept.push_back(at);
    todo.push_back({from, at});
    todo.push_back({at, to});
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace jalon
