// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/section_lines.h"

#include <algorithm>
#include <cmath>

#include "base/serial.h"
#include "cloud/sections/section_pieces.h"

namespace jalon {

namespace {

constexpr double kPointsPerCell =
    1.5;  // fewer leave most cells empty, and nodes tell little of the noise
constexpr double kMostCellGaps = 0.5;  // of a gap: larger cells would bridge it
constexpr uint32_t kSparse = 3;        // times as many points have cells that take a neighbour's
constexpr double kHopCells = 3;        // a longer step back beside the chain is none of its own
constexpr double kBesideCells = 2;
constexpr size_t kLeastOfLoop = 4;          // nodes
constexpr uint32_t kNodesOfLook = 1 << 13;  // with their points: below 10 ms

class LineMaker {
 public:
  LineMaker(std::span<const Vec2> points, const SectionSettings& settings, Task& task)
      : points_(points), settings_(settings), task_(task) {}

  std::vector<SectionLine> run() {
    std::vector<SectionLine> lines;
    if (points_.size() < 2) return lines;
    thin();
    const SectionPieces pieces_of(points_, nodes_, order_, cell_m_, settings_.tolerance_m);
    for (auto& chain : chain_nodes(nodes_, cell_m_, settings_.gap_m, task_)) {
      task_.checkpoint(0);
      leave_stragglers(chain);
      if (chain.size() < 2) continue;
      SectionLine line = line_of(pieces_of, std::move(chain));
      if (line.vertices.size() >= 2 && line.length_m >= settings_.min_length_m)
        lines.push_back(std::move(line));
    }
    return lines;
  }
  double cell_m() const { return cell_m_; }

 private:
  // Cells as small as the tolerance, or so large that they hold some points each.
  void thin() {
    cell_m_ = settings_.tolerance_m;
    for (;;) {
      task_.checkpoint(0);
      nodes_ = thin_points(points_, cell_m_, order_, task_);
      const bool filled = static_cast<double>(points_.size()) >=
                          kPointsPerCell * static_cast<double>(nodes_.size());
      if (filled || 2 * cell_m_ > kMostCellGaps * settings_.gap_m) break;
      cell_m_ *= 2;
    }
    join_sparse_cells();
  }

  // The few points that noise puts into the next cell go to the cell that has the others, or a chain would pass it by
  // and come back for it.
  void join_sparse_cells() {
    const std::vector<uint32_t> into = fullest_neighbours(nodes_, cell_m_, task_);
    std::vector<uint32_t> root(nodes_.size());
    for (uint32_t i = 0; i < nodes_.size(); ++i) {
      if (i % kNodesOfLook == 0) task_.checkpoint(0);
      root[i] = i;
      while (nodes_[into[root[i]]].count >= kSparse * nodes_[root[i]].count)
        root[i] = into[root[i]];
    }
    std::vector<std::vector<uint32_t>> members(nodes_.size());
    for (uint32_t i = 0; i < nodes_.size(); ++i) members[root[i]].push_back(i);
    std::vector<ProfileNode> joined;
    std::vector<uint32_t> order;
    for (uint32_t i = 0; i < nodes_.size(); ++i) {
      if (i % kNodesOfLook == 0) task_.checkpoint(0);
      if (members[i].empty()) continue;
      joined.push_back({nodes_[i].middle, static_cast<uint32_t>(order.size()), 0});
      for (const uint32_t member : members[i]) {
        const auto first = order_.begin() + nodes_[member].first;
        order.insert(order.end(), first, first + nodes_[member].count);
        joined.back().count += nodes_[member].count;
      }
    }
    nodes_ = std::move(joined);
    order_ = std::move(order);
  }

  // A chain that has come to its end may have stepped back to a node beside it that it had passed by.
  void leave_stragglers(std::vector<uint32_t>& chain) const {
    const auto apart = [&](uint32_t a, uint32_t b) { return norm(middle(a) - middle(b)); };
    for (int side = 0; side < 2; ++side) {
      while (chain.size() > 2 &&
             apart(chain.back(), chain[chain.size() - 2]) > kHopCells * cell_m_ &&
             std::any_of(chain.begin(), chain.end() - 1, [&](uint32_t node) {
               return apart(node, chain.back()) <= kBesideCells * cell_m_;
             }))
        chain.pop_back();
      std::reverse(chain.begin(), chain.end());
    }
  }

  SectionLine line_of(const SectionPieces& pieces_of, std::vector<uint32_t> chain) const {
    SectionLine line;
    line.is_closed = is_loop(chain);
    if (line.is_closed) begin_far_out(chain);
    std::vector<uint32_t> kept = simplified(chain);
    if (line.is_closed) kept = pieces_of.tidied_loop(chain, std::move(kept));
    if (line.is_closed && kept.size() < kLeastOfLoop) {  // there and back again
      line.is_closed = false;
      chain.pop_back();
      kept = simplified(chain);
    }
    if (!line.is_closed) kept = pieces_of.tidied(chain, std::move(kept));
    std::vector<SectionPiece> pieces;
    for (size_t k = 0; k + 1 < kept.size(); ++k)
      pieces.push_back(pieces_of.fit(chain, kept[k], kept[k + 1]));
    const auto corner = [&](size_t k, size_t next) {
      return pieces_of.corner(pieces[k], pieces[next], middle(chain[pieces[k].to]));
    };
    if (!line.is_closed)
      line.vertices.push_back(end_of(pieces_of, chain.front(), pieces.front(), -1));
    for (size_t k = 0; k + 1 < pieces.size(); ++k) line.vertices.push_back(corner(k, k + 1));
    line.vertices.push_back(line.is_closed ? corner(pieces.size() - 1, 0)
                                           : end_of(pieces_of, chain.back(), pieces.back(), 1));
    measure(pieces_of, chain, pieces, line);
    return line;
  }

  std::vector<uint32_t> simplified(const std::vector<uint32_t>& chain) const {
    return simplify(middles_of(chain), SectionPieces::kFirstShare * settings_.tolerance_m);
  }
  Vec2 middle(uint32_t node) const { return nodes_[node].middle; }
  std::vector<Vec2> middles_of(const std::vector<uint32_t>& chain) const {
    std::vector<Vec2> middles;
    for (const uint32_t node : chain) middles.push_back(middle(node));
    return middles;
  }

  // Does it come back to where it began?
  bool is_loop(const std::vector<uint32_t>& chain) const {
    if (chain.size() < kLeastOfLoop) return false;
    double length = 0;
    for (size_t i = 1; i < chain.size(); ++i)
      length += norm(middle(chain[i]) - middle(chain[i - 1]));
    const double open = norm(middle(chain.back()) - middle(chain.front()));
    return open <= settings_.gap_m && open <= length / 2 && length > 2 * settings_.gap_m;
  }

  // A loop begins anywhere; the node farthest from there is near a corner. It then stands at both ends.
  void begin_far_out(std::vector<uint32_t>& chain) const {
    size_t far = 0;
    const auto out = [&](size_t i) { return norm(middle(chain[i]) - middle(chain[0])); };
    for (size_t i = 1; i < chain.size(); ++i)
      if (out(i) > out(far)) far = i;
    std::rotate(chain.begin(), chain.begin() + static_cast<ptrdiff_t>(far), chain.end());
    chain.push_back(chain.front());
  }

  // As far along the piece, or back, as the points of the outermost node reach.
  static Vec2 end_of(const SectionPieces& pieces_of, uint32_t node, const SectionPiece& piece,
                     double sign) {
    double far = -INFINITY;
    pieces_of.for_each_point(node, [&](const Vec2& p) {
      const Vec2 d = p - piece.middle;
      far = std::max(far, sign * (d.u * piece.along.u + d.v * piece.along.v));
    });
    return piece.middle + piece.along * (sign * far);
  }

  // Length, and how far the points lie from it: those of a node from the sides next to it.
  static void measure(const SectionPieces& pieces_of, const std::vector<uint32_t>& chain,
                      const std::vector<SectionPiece>& pieces, SectionLine& line) {
    const size_t sides = pieces.size(), vertices = line.vertices.size();
    const auto vertex = [&](size_t side) {  // where a side begins
      return line.is_closed ? line.vertices[(side + vertices - 1) % vertices] : line.vertices[side];
    };
    const auto from_side = [&](size_t side, const Vec2& p) {
      const Vec2 a = vertex(side), d = vertex(side + 1) - a, q = p - a;
      const double squared = d.u * d.u + d.v * d.v;
      const double t = squared > 0 ? std::clamp((q.u * d.u + q.v * d.v) / squared, 0.0, 1.0) : 0;
      return norm(q - d * t);
    };
    for (size_t s = 0; s < sides; ++s) line.length_m += norm(vertex(s + 1) - vertex(s));
    double sum = 0;
    const size_t nodes = chain.size() - (line.is_closed ? 1 : 0);
    for (size_t i = 0, s = 0; i < nodes; ++i) {
      while (s + 1 < sides && i > pieces[s].to) ++s;
      pieces_of.for_each_point(chain[i], [&](const Vec2& p) {
        double near = from_side(s, p);
        if (s + 1 < sides || line.is_closed) near = std::min(near, from_side((s + 1) % sides, p));
        if (s > 0 || line.is_closed) near = std::min(near, from_side((s + sides - 1) % sides, p));
        sum += near * near;
        line.max_m = std::max(line.max_m, near);
        ++line.points;
      });
    }
    line.rms_m = std::sqrt(sum / static_cast<double>(line.points));
  }

  std::span<const Vec2> points_;
  const SectionSettings& settings_;
  Task& task_;
  double cell_m_ = 0;
  std::vector<ProfileNode> nodes_;
  std::vector<uint32_t> order_;
};

}  // namespace

std::vector<SectionLine> section_lines(std::span<const Vec2> points,
                                       const SectionSettings& settings, double& cell_m,
                                       Task& task) {
  std::vector<Vec2> sorted(points.begin(), points.end());
  serial_sort(task, sorted.begin(), sorted.end(),
              [](const Vec2& a, const Vec2& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
  LineMaker maker(sorted, settings, task);
  std::vector<SectionLine> lines = maker.run();
  cell_m = maker.cell_m();
  return lines;
}

}  // namespace jalon
