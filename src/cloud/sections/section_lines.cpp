// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/section_lines.h"

#include <algorithm>
#include <cmath>

#include "spatial/polylines.h"

namespace jalon {

namespace {

constexpr double kPointsPerCell = 3;   // fewer leave cells empty, where a chain may break
constexpr double kMostCellGaps = 0.5;  // of a gap: larger cells would bridge it
constexpr size_t kLeastOfLoop = 4;     // nodes
constexpr size_t kNodesWithoutEnds =
    5;  // of a piece that leaves its end nodes, which hold the corner, out
constexpr size_t kShortPiece = 4;  // nodes: what the cells of a corner leave of it
constexpr int kTidyRounds = 3;
constexpr double kJoinedShare =
    0.75;  // of the tolerance: on a bend the lines meet farther off than their nodes lie
constexpr double kLeastSine = 0.17;  // 10 degrees: flatter neighbours meet anywhere
constexpr double kCornerReach = 3;   // cells: how far a corner may lie from its node

double length_of(const Vec2& d) { return std::sqrt(d.u * d.u + d.v * d.v); }
double cross_of(const Vec2& a, const Vec2& b) { return a.u * b.v - a.v * b.u; }

/// A straight piece: its line, and the nodes that it was fitted to.
struct Piece {
  Vec2 middle, along;
  size_t from, to;  ///< places in the chain, both included
  Vec2 foot(const Vec2& p) const {
    const Vec2 d = p - middle;
    return middle + along * (d.u * along.u + d.v * along.v);
  }
  double distance(const Vec2& p) const { return std::fabs(cross_of(along, p - middle)); }
};

class LineMaker {
 public:
  LineMaker(std::span<const Vec2> points, const SectionSettings& settings)
      : points_(points), settings_(settings) {}

  std::vector<SectionLine> run() {
    std::vector<SectionLine> lines;
    if (points_.size() < 2) return lines;
    thin();
    for (auto& chain : chain_nodes(nodes_, cell_m_, settings_.gap_m)) {
      if (chain.size() < 2) continue;
      SectionLine line = line_of(std::move(chain));
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
      nodes_ = thin_points(points_, cell_m_, order_);
      const bool filled = static_cast<double>(points_.size()) >=
                          kPointsPerCell * static_cast<double>(nodes_.size());
      if (filled || 2 * cell_m_ > kMostCellGaps * settings_.gap_m) return;
      cell_m_ *= 2;
    }
  }

  Vec2 at(uint32_t node) const { return nodes_[node].middle; }

  SectionLine line_of(std::vector<uint32_t> chain) {
    SectionLine line;
    line.is_closed = is_loop(chain);
    if (line.is_closed) begin_at_corner(chain);
    std::vector<Vec2> middles;
    for (const uint32_t node : chain) middles.push_back(at(node));
    std::vector<uint32_t> kept = simplify(middles, settings_.tolerance_m);
    if (line.is_closed && kept.size() < kLeastOfLoop) {  // there and back again
      line.is_closed = false;
      chain.pop_back();
      middles.pop_back();
      kept = simplify(middles, settings_.tolerance_m);
    }
    for (int round = 0; round < kTidyRounds; ++round)
      kept = without_short_pieces(chain, with_longest_pieces(chain, kept));
    std::vector<Piece> pieces;
    for (size_t k = 0; k + 1 < kept.size(); ++k) pieces.push_back(fit(chain, kept[k], kept[k + 1]));
    if (!line.is_closed) line.vertices.push_back(end_of(chain, pieces.front(), true));
    for (size_t k = 0; k + 1 < pieces.size(); ++k)
      line.vertices.push_back(corner(pieces[k], pieces[k + 1], middles[kept[k + 1]]));
    line.vertices.push_back(line.is_closed ? corner(pieces.back(), pieces.front(), middles.back())
                                           : end_of(chain, pieces.back(), false));
    measure(chain, pieces, line);
    return line;
  }

  // Does it come back to where it began?
  bool is_loop(const std::vector<uint32_t>& chain) const {
    if (chain.size() < kLeastOfLoop) return false;
    double length = 0;
    for (size_t i = 1; i < chain.size(); ++i) length += length_of(at(chain[i]) - at(chain[i - 1]));
    const double open = length_of(at(chain.back()) - at(chain.front()));
    return open <= settings_.gap_m && open <= length / 2 && length > 2 * settings_.gap_m;
  }

  // A loop begins where nobody would look for a corner; the node farthest from there is one. It stands at both ends.
  void begin_at_corner(std::vector<uint32_t>& chain) const {
    size_t far = 0;
    for (size_t i = 1; i < chain.size(); ++i)
      if (length_of(at(chain[i]) - at(chain[0])) > length_of(at(chain[far]) - at(chain[0])))
        far = i;
    std::rotate(chain.begin(), chain.begin() + static_cast<ptrdiff_t>(far), chain.end());
    chain.push_back(chain.front());
  }

  template <class F>
  void for_each_point(uint32_t node, F&& f) const {
    for (uint32_t k = nodes_[node].first; k < nodes_[node].first + nodes_[node].count; ++k)
      f(points_[order_[k]]);
  }

  Piece fit(const std::vector<uint32_t>& chain, size_t from, size_t to) const {
    const Vec2 chord = at(chain[to]) - at(chain[from]);
    const double length = length_of(chord);
    Piece piece{at(chain[from]), length > 0 ? chord * (1 / length) : Vec2{1, 0}, from, to};
    const size_t margin = to - from + 1 >= kNodesWithoutEnds ? 1 : 0;
    const Vec2 reference = piece.middle;
    double n = 0;
    Vec2 sum{0, 0};
    for (size_t i = from + margin; i + margin <= to; ++i)
      for_each_point(chain[i], [&](const Vec2& p) {
        sum = sum + (p - reference);
        n += 1;
      });
    const Vec2 mean = reference + sum * (1 / n);
    double uu = 0, uv = 0, vv = 0;
    for (size_t i = from + margin; i + margin <= to; ++i)
      for_each_point(chain[i], [&](const Vec2& p) {
        const Vec2 d = p - mean;
        uu += d.u * d.u, uv += d.u * d.v, vv += d.v * d.v;
      });
    if (!(uu + vv > 0)) return piece;
    const double angle = 0.5 * std::atan2(2 * uv, uu - vv);
    Vec2 along{std::cos(angle), std::sin(angle)};
    const double onward = along.u * piece.along.u + along.v * piece.along.v;
    // Of a short piece in the noise the points may spread across it: its chord tells more.
    if (std::fabs(onward) < std::sqrt(0.5)) return piece;
    piece.middle = mean;
    piece.along = onward < 0 ? along * -1.0 : along;
    return piece;
  }

  // Neighbours whose nodes one line fits within the tolerance as well: chords of cells zigzag where lines of all points
  // do not.
  std::vector<uint32_t> with_longest_pieces(const std::vector<uint32_t>& chain,
                                            const std::vector<uint32_t>& kept) const {
    std::vector<uint32_t> out{kept.front()};
    for (size_t k = 1; k < kept.size(); ++k) {
      while (out.size() > 1 && one_line(chain, out[out.size() - 2], kept[k])) out.pop_back();
      out.push_back(kept[k]);
    }
    return out;
  }
  bool one_line(const std::vector<uint32_t>& chain, size_t from, size_t to) const {
    const Piece piece = fit(chain, from, to);
    const size_t margin = to - from + 1 >= kNodesWithoutEnds ? 1 : 0;
    for (size_t i = from + margin; i + margin <= to; ++i)
      if (piece.distance(at(chain[i])) > kJoinedShare * settings_.tolerance_m) return false;
    return true;
  }

  // The cell of a corner has its mean within it, which cuts it off: a short piece goes where its nodes are within the
  // tolerance of the lines before and behind it.
  std::vector<uint32_t> without_short_pieces(const std::vector<uint32_t>& chain,
                                             const std::vector<uint32_t>& kept) const {
    if (kept.size() < 4) return kept;
    std::vector<uint32_t> out{kept.front()};
    size_t k = 1;
    for (; k + 2 < kept.size(); ++k) {
      const uint32_t from = kept[k], to = kept[k + 1];
      if (to - from + 1 > kShortPiece || !corner_holds(chain, fit(chain, out.back(), from),
                                                       fit(chain, to, kept[k + 2]), from, to)) {
        out.push_back(from);
        continue;
      }
      out.push_back((from + to) / 2);
      ++k;
    }
    for (; k < kept.size(); ++k) out.push_back(kept[k]);
    return out;
  }
  bool corner_holds(const std::vector<uint32_t>& chain, const Piece& before, const Piece& behind,
                    size_t from, size_t to) const {
    for (size_t i = from; i <= to; ++i)
      if (std::min(before.distance(at(chain[i])), behind.distance(at(chain[i]))) >
          settings_.tolerance_m)
        return false;
    return true;
  }

  Vec2 corner(const Piece& a, const Piece& b, const Vec2& node) const {
    const double sine = cross_of(a.along, b.along);
    const Vec2 between = (a.foot(node) + b.foot(node)) * 0.5;
    if (std::fabs(sine) < kLeastSine) return between;
    const Vec2 meeting = a.middle + a.along * (cross_of(b.middle - a.middle, b.along) / sine);
    return length_of(meeting - node) <= kCornerReach * cell_m_ ? meeting : between;
  }

  // As far as the points of the outermost node reach.
  Vec2 end_of(const std::vector<uint32_t>& chain, const Piece& piece, bool first) const {
    const double sign = first ? -1 : 1;
    double far = -INFINITY;
    for_each_point(first ? chain.front() : chain.back(), [&](const Vec2& p) {
      const Vec2 d = p - piece.middle;
      far = std::max(far, sign * (d.u * piece.along.u + d.v * piece.along.v));
    });
    return piece.middle + piece.along * (sign * far);
  }

  // Length, and how far the points lie from it: those of a node from the sides next to it.
  void measure(const std::vector<uint32_t>& chain, const std::vector<Piece>& pieces,
               SectionLine& line) const {
    const size_t sides = pieces.size(), vertices = line.vertices.size();
    const auto vertex = [&](size_t side) {  // where a side begins
      return line.is_closed ? line.vertices[(side + vertices - 1) % vertices] : line.vertices[side];
    };
    const auto from_side = [&](size_t side, const Vec2& p) {
      const Vec2 a = vertex(side), d = vertex(side + 1) - a, q = p - a;
      const double squared = d.u * d.u + d.v * d.v;
      const double t = squared > 0 ? std::clamp((q.u * d.u + q.v * d.v) / squared, 0.0, 1.0) : 0;
      return length_of(q - d * t);
    };
    for (size_t s = 0; s < sides; ++s) line.length_m += length_of(vertex(s + 1) - vertex(s));
    double sum = 0;
    const size_t nodes = chain.size() - (line.is_closed ? 1 : 0);
    for (size_t i = 0, s = 0; i < nodes; ++i) {
      while (s + 1 < sides && i > pieces[s].to) ++s;
      for_each_point(chain[i], [&](const Vec2& p) {
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
  double cell_m_ = 0;
  std::vector<ProfileNode> nodes_;
  std::vector<uint32_t> order_;
};

}  // namespace

std::vector<SectionLine> section_lines(std::span<const Vec2> points,
                                       const SectionSettings& settings, double& cell_m) {
  std::vector<Vec2> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const Vec2& a, const Vec2& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
  LineMaker maker(sorted, settings);
  std::vector<SectionLine> lines = maker.run();
  cell_m = maker.cell_m();
  return lines;
}

}  // namespace jalon
