// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/polylines.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/serial.h"
#include "spatial/node_cells.h"

namespace jalon {

namespace {

constexpr int kFilled =
    6;  // of the eight cells about a node: a line has two to four, and a corner five
constexpr size_t kNodesPerLook = size_t{1} << 14;

double squared_between(const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  return d.u * d.u + d.v * d.v;
}

std::vector<NodeCell> cells_of(std::span<const ProfileNode> nodes, double cell_m) {
  std::vector<NodeCell> cells;
  cells.reserve(nodes.size());
  for (const ProfileNode& node : nodes) cells.push_back(cell_at(node.middle, cell_m));
  return cells;
}

// Walks over nodes that stand in the order of their cells.
class Chainer {
 public:
  Chainer(std::span<const ProfileNode> nodes, double cell_m, double gap_m, Task& task)
      : nodes_(nodes),
        task_(task),
        gap_m_(gap_m),
        cell_m_(cell_m),
        used_(nodes.size(), 0),
        rings_(static_cast<int64_t>(std::ceil(gap_m / cell_m))),
        cells_(cells_of(nodes, cell_m)),
        table_(cells_),
        bits_(cells_, std::max<int64_t>(1, rings_)) {}

  std::vector<std::vector<uint32_t>> run() {
    std::vector<std::vector<uint32_t>> chains;
    leave_out_faces();
    for (uint32_t i = 0; i < nodes_.size(); ++i) {
      if (used_[i] != 0) continue;
      use(i);
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

  void use(uint32_t node) {
    used_[node] = 1;
    // Of two nodes in one cell, by rounding, the other one is what the cell shows.
    if (bits_.known() && table_.at(cells_[node]) == node) bits_.clear(cells_[node]);
  }

  int nodes_around(uint32_t node) const {
    int around = 0;
    if (bits_.known()) {
      for (int64_t c = -1; c <= 1; ++c) around += std::popcount(bits_.window(cells_[node], c, 1));
      return around - 1;
    }
    for (int64_t c = -1; c <= 1; ++c)
      for (int64_t r = -1; r <= 1; ++r)
        around += (c != 0 || r != 0) && node_at(node, c, r) != kNoNode;
    return around;
  }

  // Where a surface lies in the slice its nodes fill an area, which has no profile but its edge.
  void leave_out_faces() {
    std::vector<uint32_t> inside;
    serial_for(task_, nodes_.size(), kNodesPerLook, [&](size_t begin, size_t end) {
      for (auto i = static_cast<uint32_t>(begin); i < end; ++i)
        if (nodes_around(i) >= kFilled) inside.push_back(i);
    });
    for (const uint32_t i : inside) use(i);
  }

  std::vector<uint32_t> walk(uint32_t from) {
    std::vector<uint32_t> chain;
    for (uint32_t next = nearest(from); next != kNoNode; next = nearest(next)) {
      use(next);
      chain.push_back(next);
      if (++walked_ % kNodesPerLook == 0) task_.checkpoint(0);
    }
    return chain;
  }

  // Ring by ring of cells: what lies in ring r is at least r - 1 cells away.
  uint32_t nearest(uint32_t from) const {
    double best = gap_m_ * gap_m_;
    uint32_t found = kNoNode;
    for (int64_t ring = 1; ring <= rings_; ++ring) {
      const double least = static_cast<double>(ring - 1) * cell_m_;
      if (found != kNoNode && least * least > best) break;
      for (int64_t c = -ring; c <= ring; ++c) {
        const bool side = c == -ring || c == ring;
        if (bits_.known()) look_in_column(from, c, ring, side, best, found);
        else
          for (int64_t r = -ring; r <= ring; r += side ? 1 : 2 * ring)
            look(from, c, r, best, found);
      }
    }
    return found;
  }

  // All rows of a ring's sides, the first and the last of what lies between.
  void look_in_column(uint32_t from, int64_t column, int64_t ring, bool side, double& best,
                      uint32_t& found) const {
    uint64_t occupied = bits_.window(cells_[from], column, ring);
    if (!side) occupied &= uint64_t{1} << 2 * ring | 1;
    for (; occupied != 0; occupied &= occupied - 1)
      look(from, column, std::countr_zero(occupied) - ring, best, found);
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
  Task& task_;
  size_t walked_ = 0;
  double gap_m_, cell_m_;
  std::vector<uint8_t> used_;
  int64_t rings_;
  std::vector<NodeCell> cells_;
  NodeTable table_;
  NodeBits bits_;
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
                                     std::vector<uint32_t>& order, Task& task) {
  std::vector<NodeCell> cells;
  cells.reserve(points.size());
  serial_for(task, points.size(), kNodesPerLook, [&](size_t begin, size_t end) {
    for (const Vec2& p : points.subspan(begin, end - begin)) cells.push_back(cell_at(p, cell_m));
  });
  order = order_of_cells(cells, task);
  std::vector<ProfileNode> nodes;
  for (uint32_t i = 0; i < order.size();) {
    if (nodes.size() % kNodesPerLook == 0) task.checkpoint(0);
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

std::vector<uint32_t> fullest_neighbours(std::span<const ProfileNode> nodes, double cell_m,
                                         Task& task) {
  const std::vector<NodeCell> cells = cells_of(nodes, cell_m);
  const NodeTable table(cells);
  std::vector<uint32_t> out(nodes.size());
  for (uint32_t i = 0; i < nodes.size(); ++i) {
    if (i % kNodesPerLook == 0) task.checkpoint(0);
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
                                               double gap_m, Task& task) {
  return Chainer(nodes, cell_m, gap_m, task).run();
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
