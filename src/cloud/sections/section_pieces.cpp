// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/section_pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace jalon {

namespace {

constexpr size_t kNodesWithoutEnds =
    5;  // of a piece that leaves its end nodes, which hold the corner, out
constexpr double kShortCells = 4;  // what the cells of a corner leave of it, and a step of noise
// Of the tolerance, from round to round: first what is straight becomes one, corner to corner; at once, a line would
// run past its corner as far as that lets it. Half of it in the end: on a bend lines meet twice as far off as their
// nodes are.
constexpr double kShares[] = {SectionPieces::kFirstShare, 0.5, 0.5};
constexpr size_t kSmoothed = 2;       // nodes to either side that tell a bend from noise
constexpr double kCornerCell = 0.75;  // cells: how far the mean of a corner's lies from its lines
constexpr double kLeastSine = 0.17;   // 10 degrees: flatter neighbours meet anywhere
constexpr double kCornerReach = 3;    // cells: how far a corner may lie from its node
constexpr double kLeastOnward = 0.7;  // cosine of 45 degrees between a line and its chord

// False where they are too flat to each other.
bool meeting_of(const SectionPiece& a, const SectionPiece& b, Vec2& out) {
  const double sine = cross(a.along, b.along);
  if (std::fabs(sine) < kLeastSine) return false;
  out = a.middle + a.along * (cross(b.middle - a.middle, b.along) / sine);
  return true;
}

// A loop begun `by` places later.
void turn_loop(std::vector<uint32_t>& chain, std::vector<uint32_t>& kept, uint32_t by) {
  chain.pop_back();
  const auto n = static_cast<uint32_t>(chain.size());
  std::rotate(chain.begin(), chain.begin() + by, chain.end());
  chain.push_back(chain.front());
  kept.pop_back();
  for (uint32_t& place : kept) place = (place + n - by) % n;
  kept.push_back(0);
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  kept.push_back(n);
}

}  // namespace

SectionPiece SectionPieces::fit(const std::vector<uint32_t>& chain, size_t from, size_t to) const {
  const Vec2 chord = at(chain[to]) - at(chain[from]);
  const double length = norm(chord);
  SectionPiece piece{at(chain[from]), length > 0 ? chord * (1 / length) : Vec2{1, 0}, from, to};
  const size_t margin = to - from + 1 >= kNodesWithoutEnds ? 1 : 0;
  const Vec2 reference = piece.middle;
  const auto for_all = [&](auto&& f) {
    for (size_t i = from + margin; i + margin <= to; ++i) for_each_point(chain[i], f);
  };
  double n = 0;
  Vec2 sum{0, 0};
  for_all([&](const Vec2& p) {
    sum = sum + (p - reference);
    n += 1;
  });
  const Vec2 mean = reference + sum * (1 / n);
  double uu = 0, uv = 0, vv = 0;
  for_all([&](const Vec2& p) {
    const Vec2 d = p - mean;
    uu += d.u * d.u, uv += d.u * d.v, vv += d.v * d.v;
  });
  if (!(uu + vv > 0)) return piece;
  const double angle = 0.5 * std::atan2(2 * uv, uu - vv);
  const Vec2 along{std::cos(angle), std::sin(angle)};
  const double onward = along.u * piece.along.u + along.v * piece.along.v;
  // Of a short piece in the noise the points may spread across it: its chord tells more.
  if (std::fabs(onward) < kLeastOnward) return piece;
  piece.middle = mean;
  piece.along = onward < 0 ? along * -1.0 : along;
  return piece;
}

Vec2 SectionPieces::corner(const SectionPiece& a, const SectionPiece& b, const Vec2& node) const {
  Vec2 meeting;
  if (meeting_of(a, b, meeting) && norm(meeting - node) <= kCornerReach * cell_m_) return meeting;
  return (a.foot(node) + b.foot(node)) * 0.5;
}

std::vector<uint32_t> SectionPieces::tidied(const std::vector<uint32_t>& chain,
                                            std::vector<uint32_t> kept) const {
  for (const double share : kShares)
    kept =
        at_meetings(chain, without_short(chain, with_longest(chain, kept, share * tolerance_m_)));
  return kept;
}

// The place where a loop begins stays an end of pieces: once in the middle of the longest, so that all corners are seen
// from both sides, then at one of these.
std::vector<uint32_t> SectionPieces::tidied_loop(std::vector<uint32_t>& chain,
                                                 std::vector<uint32_t> kept) const {
  kept = tidied(chain, std::move(kept));
  size_t longest = 0;
  const auto nodes = [&](size_t k) { return kept[k + 1] - kept[k]; };
  for (size_t k = 1; k + 1 < kept.size(); ++k)
    if (nodes(k) > nodes(longest)) longest = k;
  turn_loop(chain, kept, kept[longest] + nodes(longest) / 2);
  kept = tidied(chain, std::move(kept));
  if (kept.size() < 3) return kept;
  turn_loop(chain, kept, kept[1]);
  // On a bend that place may be an end like the others.
  if (one_line(chain, kept[kept.size() - 3], kept.back(), std::end(kShares)[-1] * tolerance_m_))
    kept.erase(kept.end() - 2);
  return kept;
}

// Neighbours whose nodes one line fits within the tolerance as well: chords of cells zigzag where lines of all points
// do not.
std::vector<uint32_t> SectionPieces::with_longest(const std::vector<uint32_t>& chain,
                                                  const std::vector<uint32_t>& kept,
                                                  double tolerance_m) const {
  std::vector<uint32_t> out{kept.front()};
  for (size_t k = 1; k < kept.size(); ++k) {
    while (out.size() > 1 && one_line(chain, out[out.size() - 2], kept[k], tolerance_m))
      out.pop_back();
    out.push_back(kept[k]);
  }
  return out;
}

bool SectionPieces::one_line(const std::vector<uint32_t>& chain, size_t from, size_t to,
                             double tolerance_m) const {
  const SectionPiece piece = fit(chain, from, to);
  const double ends_m = std::max(tolerance_m, std::min(kCornerCell * cell_m_, tolerance_m_));
  for (size_t i = from; i <= to; ++i) {
    double sum = 0, n = 0;
    for (size_t k = std::max(from + kSmoothed, i) - kSmoothed; k <= std::min(to, i + kSmoothed);
         ++k) {
      const double count = nodes_[chain[k]].count;
      sum += count * piece.offset(at(chain[k]));
      n += count;
    }
    if (std::fabs(sum / n) > (i == from || i == to ? ends_m : tolerance_m)) return false;
  }
  return true;
}

// The cell of a corner has its mean within it, which cuts it off: a short piece goes where its nodes are within the
// tolerance of the lines before and behind it, and these meet there.
std::vector<uint32_t> SectionPieces::without_short(const std::vector<uint32_t>& chain,
                                                   const std::vector<uint32_t>& kept) const {
  std::vector<uint32_t> out{kept.front()};
  size_t k = 1;
  for (; k + 2 < kept.size(); ++k) {
    uint32_t place = kept[k];
    const double length = norm(at(chain[kept[k + 1]]) - at(chain[kept[k]]));
    if (length <= kShortCells * cell_m_ &&
        meet_between(chain, fit(chain, out.back(), kept[k]), fit(chain, kept[k + 1], kept[k + 2]),
                     place))
      ++k;
    out.push_back(place);
  }
  for (; k < kept.size(); ++k) out.push_back(kept[k]);
  return out;
}

// Ends of pieces at the nodes nearest to where the lines meet: a line that took some nodes round its corner gives them
// back.
std::vector<uint32_t> SectionPieces::at_meetings(const std::vector<uint32_t>& chain,
                                                 std::vector<uint32_t> kept) const {
  for (size_t k = 1; k + 1 < kept.size(); ++k) {
    Vec2 meeting;
    if (!meeting_of(fit(chain, kept[k - 1], kept[k]), fit(chain, kept[k], kept[k + 1]), meeting))
      continue;
    double least = kCornerReach * cell_m_;
    for (uint32_t i = kept[k - 1] + 1; i < kept[k + 1]; ++i)
      if (const double off = norm(at(chain[i]) - meeting); off < least) {
        least = off;
        kept[k] = i;
      }
  }
  return kept;
}

bool SectionPieces::meet_between(const std::vector<uint32_t>& chain, const SectionPiece& before,
                                 const SectionPiece& behind, uint32_t& place) const {
  Vec2 meeting;
  if (!meeting_of(before, behind, meeting)) return false;
  double least = INFINITY;
  for (size_t i = before.to; i <= behind.from; ++i) {
    const Vec2 node = at(chain[i]);
    if (std::min(before.distance(node), behind.distance(node)) > tolerance_m_) return false;
    if (norm(node - meeting) >= least) continue;
    least = norm(node - meeting);
    place = static_cast<uint32_t>(i);
  }
  return least <= kCornerReach * cell_m_;
}

}  // namespace jalon
