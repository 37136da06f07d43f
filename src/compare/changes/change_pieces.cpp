// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/parallel.h"
#include "compare/changes/surface_parts.h"
#include "compare/detection/detection.h"
#include "spatial/union_find.h"

namespace jalon {

namespace {

constexpr size_t kPieceSample = 200;  // points that gaps are measured between
constexpr uint8_t kMovedEvidence = static_cast<uint8_t>(ChangeEvidence::kMovedSurface);
// Of a piece's size: a surface before or behind another by no more than that is it, moved.
constexpr double kShiftOfSize = 0.1;
constexpr double kVotes = 0.3;        // of a piece's points, with their nearest in the other
constexpr double kMovedPiece = 0.5;   // of a piece's points: it is a surface that moved
constexpr double kSamePlane = 0.966;  // cosine of 15 degrees
constexpr double kSameOffset = 0.5;   // of the larger offset
constexpr double kOffPlane = 4;       // thicknesses
constexpr double kBesideCells = 3, kBesideSize = 0.15;  // gap of pieces of one thing
constexpr double kStepOff =
    1.5;  // of the way that a surface moved: from its rim before to that after
constexpr double kSwept = 0.5;  // of a piece's points: it is a part of what swept them
constexpr double kGapOfSize =
    1;  // of the larger piece: what stands before a surface hides less of it

ChangePiece piece_of(const Epoch& epoch, const Cloud& other, const ChangeRegion& region,
                     bool is_after) {
  ChangePiece out;
  out.is_after = is_after;
  out.label = region.label;
  out.points = region.indices.size();
  out.centroid = region.centroid - epoch.origin;
  out.normal = region.axes.vectors[0];
  out.thickness_m = std::sqrt(std::max(0.0, region.axes.values[0]));
  const auto evidence = epoch.comparison->points.require("evidence").values<uint8_t>();
  const auto level = epoch.comparison->points.require("level_of_detection").values<float>();
  const auto distance = epoch.comparison->points.require("distance").values<double>();
  for (const uint32_t i : region.indices) out.box.add(epoch.local(i));
  out.size_m = norm(out.box.max - out.box.min);
  size_t moved = 0, measured = 0;
  for (const uint32_t i : region.indices) {
    const bool is_near = level[i] >= 0 && std::abs(distance[i]) <= kShiftOfSize * out.size_m;
    moved += is_near || evidence[i] == kMovedEvidence ? 1 : 0;
    if (const uint32_t j = epoch.nearest(i); j != kNoPoint) {
      out.offset_m += dot(epoch.cloud().point(i) - other.point(j), out.normal);
      ++measured;
    }
  }
  if (measured > 0) out.offset_m /= static_cast<double>(measured);
  out.moved_share = static_cast<double>(moved) / static_cast<double>(out.points);
  const size_t step = out.points / kPieceSample + 1;
  for (size_t k = 0; k < out.points; k += step)
    out.sample.push_back(epoch.local(region.indices[k]));
  return out;
}

double gap_of(const ChangePiece& a, const ChangePiece& b) {
  double least = INFINITY;
  for (const Vec3& p : a.sample)
    for (const Vec3& q : b.sample) least = std::min(least, squared_norm(p - q));
  return std::sqrt(least);
}

bool is_same_surface(const ChangePiece& a, const ChangePiece& b) {
  const double facing = dot(a.normal, b.normal);
  if (std::abs(facing) < kSamePlane) return false;
  const double other = facing > 0 ? b.offset_m : -b.offset_m;
  const double larger = std::max(std::abs(a.offset_m), std::abs(other));
  if (a.offset_m * other <= 0 || std::abs(a.offset_m - other) > kSameOffset * larger) return false;
  const double off = std::max(std::abs(dot(b.centroid - a.centroid, a.normal)),
                              std::abs(dot(b.centroid - a.centroid, b.normal)));
  return off <= kOffPlane * std::max(a.thickness_m, b.thickness_m) + larger;
}

bool belong_together(const ChangePiece& a, const ChangePiece& b, double cell_m) {
  const bool are_surfaces = a.moved_share >= kMovedPiece && b.moved_share >= kMovedPiece;
  const double beside = std::max(kBesideCells * cell_m, kBesideSize * std::min(a.size_m, b.size_m));
  const double reach =
      are_surfaces ? std::max(beside, kGapOfSize * std::max(a.size_m, b.size_m)) : beside;
  if (box_gap(a.box, b.box) > reach) return false;
  if (are_surfaces) return is_same_surface(a, b) && gap_of(a, b) <= reach;
  return gap_of(a, b) <= beside;
}

// Of two epochs: is one where the other was before it moved?
bool is_moved_to(const ChangePiece& a, const ChangePiece& b, double cell_m) {
  if (a.moved_share < kMovedPiece || b.moved_share < kMovedPiece) return false;
  if (std::abs(dot(a.normal, b.normal)) < kSamePlane) return false;
  const double reach = std::max(kBesideCells * cell_m,
                                kStepOff * std::max(std::abs(a.offset_m), std::abs(b.offset_m)));
  return box_gap(a.box, b.box) <= reach && gap_of(a, b) <= reach;
}

// How many of a piece's points lie where a surface of the other epoch went on its way: within that way of it.
double swept_share(const ChangePiece& piece, const Vec3& origin, const ChangePiece& moved,
                   const Epoch& in, Task& task) {
  const double way = kStepOff * std::abs(moved.offset_m);
  if (box_gap(piece.box, moved.box) > way) return 0;
  const auto tree = in.cloud().octree(task);
  std::vector<Neighbour> near;
  size_t swept = 0;
  for (const Vec3& p : piece.sample) {
    tree->radius(p + origin, way, near);
    swept += std::any_of(near.begin(), near.end(), [&](const Neighbour& n) {
      return in.regions.labels[n.index] == moved.label;
    });
  }
  return static_cast<double>(swept) / static_cast<double>(piece.sample.size());
}

// How many of a piece's points have their nearest in which region of the other epoch.
std::map<uint32_t, size_t> votes_of(const Epoch& epoch, const Epoch& other, uint32_t label) {
  std::map<uint32_t, size_t> out;
  for (const uint32_t i : epoch.regions.regions[label - 1].indices)
    if (const uint32_t j = epoch.nearest(i); j != kNoPoint && other.regions.labels[j] > 0)
      ++out[other.regions.labels[j]];
  return out;
}

// Pieces of a surface that moved, of groups that one epoch alone has, each with the piece of the other epoch that swept
// most of it.
std::vector<std::pair<size_t, size_t>> pieces_swept(const Epoch& before, const Epoch& after,
                                                    const std::vector<ChangePiece>& pieces,
                                                    UnionFind& sets, Task& task) {
  std::map<uint32_t, std::array<bool, 2>> has;  // of a group: before, after
  for (size_t k = 0; k < pieces.size(); ++k)
    has[sets.find(static_cast<uint32_t>(k))][pieces[k].is_after ? 1 : 0] = true;
  std::vector<std::pair<size_t, size_t>> out;
  for (size_t a = 0; a < pieces.size(); ++a) {
    const ChangePiece& piece = pieces[a];
    const auto& epochs = has[sets.find(static_cast<uint32_t>(a))];
    if (piece.moved_share < kMovedPiece || (epochs[0] && epochs[1])) continue;
    double most = kSwept;
    size_t of = a;
    for (size_t b = 0; b < pieces.size(); ++b) {
      if (pieces[b].is_after == piece.is_after || pieces[b].moved_share < kMovedPiece) continue;
      const double share =
          swept_share(piece, before.origin, pieces[b], piece.is_after ? before : after, task);
      if (share > most) most = share, of = b;
    }
    if (of != a) out.emplace_back(a, of);
  }
  return out;
}

}  // namespace

double box_gap(const Box3& a, const Box3& b) {
  Vec3 gap;
  for (int k = 0; k < 3; ++k) gap[k] = std::max({0.0, a.min[k] - b.max[k], b.min[k] - a.max[k]});
  return norm(gap);
}

std::vector<ChangePiece> change_pieces(const Epoch& before, const Epoch& after, Task& task) {
  const size_t first = after.regions.regions.size();
  std::vector<ChangePiece> out(first + before.regions.regions.size());
  parallel_for(task, out.size(), 1, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k)
      out[k] = k < first
                   ? piece_of(after, before.cloud(), after.regions.regions[k], true)
                   : piece_of(before, after.cloud(), before.regions.regions[k - first], false);
  });
  return out;
}

std::vector<std::vector<size_t>> group_pieces(const Epoch& before, const Epoch& after,
                                              const std::vector<ChangePiece>& pieces, double cell_m,
                                              Task& task) {
  const size_t first = after.regions.regions.size();
  UnionFind sets(pieces.size());
  const auto join = [&](size_t a, size_t b) {
    sets.join(static_cast<uint32_t>(a), static_cast<uint32_t>(b));
  };
  // 1.
  for (size_t k = 0; k < pieces.size(); ++k) {
    const ChangePiece& piece = pieces[k];
    const auto votes = piece.is_after ? votes_of(after, before, piece.label)
                                      : votes_of(before, after, piece.label);
    for (const auto& [label, n] : votes)
      if (static_cast<double>(n) >= kVotes * static_cast<double>(piece.points))
        join(k, piece.is_after ? first + label - 1 : label - 1);
  }
  // 2, 3.
  for (size_t a = 0; a < pieces.size(); ++a) {
    task.checkpoint(static_cast<double>(a) / static_cast<double>(pieces.size()));
    for (size_t b = a + 1; b < pieces.size(); ++b)
      if (pieces[a].is_after == pieces[b].is_after ? belong_together(pieces[a], pieces[b], cell_m)
                                                   : is_moved_to(pieces[a], pieces[b], cell_m))
        join(a, b);
  }
  // 4.
  for (const Epoch* epoch : {&after, &before})
    for (const auto& [a, b] : parts_of_one_surface(*epoch, task))
      epoch == &after ? join(a - 1, b - 1) : join(first + a - 1, first + b - 1);
  // 5.
  for (const auto& [a, b] : pieces_swept(before, after, pieces, sets, task)) join(a, b);
  std::map<uint32_t, std::vector<size_t>> groups;
  std::vector<uint32_t> order;
  for (size_t k = 0; k < pieces.size(); ++k) {
    const uint32_t root = sets.find(static_cast<uint32_t>(k));
    if (groups[root].empty()) order.push_back(root);
    groups[root].push_back(k);
  }
  std::vector<std::vector<size_t>> out;
  for (const uint32_t root : order) out.push_back(std::move(groups[root]));
  return out;
}

}  // namespace jalon
