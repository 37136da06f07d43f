// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Search at a constant level (Girardeau-Montaut 2006, 4.4): the cells around the query's own one, shell by shell, until
// the k-th distance fits into the sphere that the shells cover.
//
// Two things are ours. Empty shells are jumped over: the next occupied shell is found by descending the sorted codes.
// And once k candidates are known, the last shell that matters is known too (2.3 step 6), so at most one more gathering
// follows.

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "base/parallel.h"
#include "spatial/octree/impl.h"
#include "spatial/partition.h"

namespace jalon {

namespace {

constexpr double kLevelGridError = 0.8661;  // as in octree_query.cpp
constexpr double kLevelRounding = 1 + 1e-12;
constexpr int64_t kEverything = int64_t{1} << 32;  // a Chebyshev distance beyond all cells
// Points around a cell, or so many times k: with more of them the adaptive search of a query is faster than to look at
// all. A cell holds most of the cloud where a single point lies far away, or where points crowd.
constexpr size_t kMostShared = 1024;
constexpr size_t kMostSharedTimesK = 16;

bool nearer(const Neighbour& a, const Neighbour& b) {
  return a.squared_distance < b.squared_distance ||
         (a.squared_distance == b.squared_distance && a.index < b.index);
}

// The occupied cells of one level, and what lies at which Chebyshev distance of a cell.
class LevelCells {
 public:
  LevelCells(const Octree& tree, int level, Task& task)
      : level_(level), cells_(tree.cells(level, task)) {}

  // Smallest Chebyshev distance > inner at which there are points; kEverything when there are none.
  int64_t next_shell(const CellNumbers& c, int64_t inner) const {
    int64_t best = kEverything;
    descend_nearest(c, inner, 0, 0, 0, cells_.size(), best);
    return best;
  }
  // Appends the sorted positions of the points in shells (inner, outer], until there are more than most.
  void gather(const CellNumbers& c, int64_t inner, int64_t outer, size_t most,
              std::vector<uint32_t>& points) const {
    const double side = 2.0 * static_cast<double>(outer) + 1;
    if (side * side * side <= 27) {  // few cells: look each up
      for (int64_t p = c.p - outer; p <= c.p + outer; ++p)
        for (int64_t q = c.q - outer; q <= c.q + outer; ++q)
          for (int64_t r = c.r - outer; r <= c.r + outer; ++r)
            if (inside(p) && inside(q) && inside(r) && distance(c, p, q, r) > inner)
              look_up(morton_code(static_cast<uint32_t>(p), static_cast<uint32_t>(q),
                                  static_cast<uint32_t>(r)),
                      most, points);
    } else {
      descend({c, inner, outer, most}, 0, 0, 0, cells_.size(), points);
    }
  }

 private:
  bool inside(int64_t v) const { return v >= 0 && v < int64_t{1} << level_; }
  static int64_t distance(const CellNumbers& c, int64_t p, int64_t q, int64_t r) {
    return std::max({std::abs(p - c.p), std::abs(q - c.q), std::abs(r - c.r)});
  }
  struct Shells {
    CellNumbers centre;
    int64_t inner, outer;
    size_t most;
  };
  static void take(const Octree::Cell& cell, size_t most, std::vector<uint32_t>& points) {
    const size_t at = points.size();
    if (at > most) return;
    points.resize(at + std::min(cell.count, most + 1));
    std::iota(points.begin() + static_cast<ptrdiff_t>(at), points.end(),
              static_cast<uint32_t>(cell.first));
  }
  void look_up(uint64_t code, size_t most, std::vector<uint32_t>& points) const {
    const auto at = std::lower_bound(
        cells_.begin(), cells_.end(), code,
        [](const Octree::Cell& cell, uint64_t wanted) { return cell.code < wanted; });
    if (at != cells_.end() && at->code == code) take(*at, most, points);
  }
  // Least and greatest Chebyshev distance between cell c and the cells below a prefix.
  std::pair<int64_t, int64_t> reach(const CellNumbers& c, int level, uint64_t prefix) const {
    const CellNumbers n = cell_numbers(prefix);
    const int down = level_ - level;
    const int64_t size = int64_t{1} << down;
    int64_t least = 0, greatest = 0;
    const uint32_t centre[3] = {c.p, c.q, c.r}, number[3] = {n.p, n.q, n.r};
    for (int axis = 0; axis < 3; ++axis) {
      const int64_t lo = int64_t{number[axis]} << down, hi = lo + size - 1, v = centre[axis];
      least = std::max({least, lo - v, v - hi});
      greatest = std::max({greatest, std::abs(v - lo), std::abs(v - hi)});
    }
    return {least, greatest};
  }
  template <class F>
  void for_children(int level, size_t begin, size_t end, F f) const {
    const int shift = 3 * (level_ - level - 1);
    while (begin < end) {
      const uint64_t prefix = cells_[begin].code >> shift;
      const auto next = std::lower_bound(
          cells_.begin() + static_cast<ptrdiff_t>(begin) + 1,
          cells_.begin() + static_cast<ptrdiff_t>(end), (prefix + 1) << shift,
          [](const Octree::Cell& cell, uint64_t code) { return cell.code < code; });
      const auto to = static_cast<size_t>(next - cells_.begin());
      f(prefix, begin, to);
      begin = to;
    }
  }
  void descend(const Shells& shells, int level, uint64_t prefix, size_t begin, size_t end,
               std::vector<uint32_t>& points) const {
    const auto [least, greatest] = reach(shells.centre, level, prefix);
    if (least > shells.outer || greatest <= shells.inner || points.size() > shells.most) return;
    if (level == level_ || (least > shells.inner && greatest <= shells.outer)) {
      for (size_t i = begin; i < end && points.size() <= shells.most; ++i)
        take(cells_[i], shells.most, points);
      return;
    }
    for_children(level, begin, end, [&](uint64_t child, size_t from, size_t to) {
      descend(shells, level + 1, child, from, to, points);
    });
  }
  void descend_nearest(const CellNumbers& c, int64_t inner, int level, uint64_t prefix,
                       size_t begin, size_t end, int64_t& best) const {
    if (begin == end) return;
    const auto [least, greatest] = reach(c, level, prefix);
    if (greatest <= inner || std::max(least, inner + 1) >= best) return;
    if (level == level_) {
      best = least;
      return;
    }
    for_children(level, begin, end, [&](uint64_t child, size_t from, size_t to) {
      descend_nearest(c, inner, level + 1, child, from, to, best);
    });
  }

  int level_;
  std::vector<Octree::Cell> cells_;
};

// The queries of one cell, with the points gathered around it so far.
class CellSearch {
 public:
  CellSearch(const Octree& octree, const LevelCells& cells, int level, uint32_t k)
      : octree_(octree),
        tree_(octree.impl()),
        cells_(cells),
        k_(std::min<size_t>(k, tree_.count)),
        most_(std::max(kMostShared, kMostSharedTimesK * k_)),
        edge_(std::ldexp(1.0, kGridBits - level)) {}

  void enter(const CellNumbers& cell) {
    cell_ = cell;
    points_.clear();
    shell_ = -1;
    complete_ = false;
  }

  void find(const Vec3& query, std::span<Neighbour> out) {
    const Vec3 q = (query - tree_.cube.origin) * tree_.inverse_step;
    // Step 1, formula 4.1: r_j = r_0 + j l. Points on a face of the covered cells are on the outer side of it by
    // rounding at most.
    const double r0 = inscribed_radius(q);
    heap_.clear();
    limit_ = std::numeric_limits<double>::infinity();
    if (!is_crowded()) scan(query, q, 0);
    // Steps 3 to 5.
    while (!complete_ && !is_crowded()) {
      const double covered =
          (r0 + static_cast<double>(std::max<int64_t>(shell_, 0)) * edge_) * (1 - 1e-12) -
          kLevelGridError;
      if (shell_ >= 0 && heap_.size() == k_ &&
          std::sqrt(heap_[0].squared_distance) * tree_.inverse_step < covered)
        break;
      const size_t known = points_.size();
      extend(r0);
      if (!is_crowded()) scan(query, q, known);
    }
    size_t found = heap_.size();
    if (is_crowded()) {
      found = octree_.knn(query, static_cast<uint32_t>(k_), out);
    } else {
      std::sort_heap(heap_.begin(), heap_.end(), nearer);
      std::copy(heap_.begin(), heap_.end(), out.begin());
    }
    std::fill(out.begin() + static_cast<ptrdiff_t>(found), out.end(),
              Neighbour{std::numeric_limits<double>::infinity(), kNoPoint});
  }

 private:
  bool is_crowded() const { return points_.size() > most_; }
  double inscribed_radius(const Vec3& q) const {
    const uint32_t number[3] = {cell_.p, cell_.q, cell_.r};
    double r = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      r = std::min(r, 0.5 * edge_ - std::abs(q[axis] - (number[axis] + 0.5) * edge_));
    return r;
  }

  // The next shells: up to the last that matters when k candidates are known, else up to the next occupied one.
  void extend(double r0) {
    int64_t outer;
    if (heap_.size() == k_) {
      const double d = std::sqrt(heap_[0].squared_distance) * tree_.inverse_step * kLevelRounding +
                       4 * kLevelGridError;
      const double j = std::ceil((d - r0) / edge_);
      outer = j < static_cast<double>(kEverything) ? std::max(static_cast<int64_t>(j), shell_ + 1)
                                                   : kEverything;
    } else {
      outer = shell_ < 0 ? 0 : cells_.next_shell(cell_, shell_);
    }
    cells_.gather(cell_, shell_, outer, most_, points_);
    shell_ = outer;
    complete_ = outer >= kEverything || points_.size() == tree_.count;
  }

  void scan(const Vec3& query, const Vec3& q, size_t from) {
    const double cx = q.x - 0.5, cy = q.y - 0.5, cz = q.z - 0.5;
    for (size_t n = from; n < points_.size(); ++n) {
      const uint32_t i = points_[n];
      const double dx = tree_.x[i] - cx, dy = tree_.y[i] - cy, dz = tree_.z[i] - cz;
      if (dx * dx + dy * dy + dz * dz > limit_) continue;
      const Neighbour candidate{squared_norm(tree_.exact_point(i) - query), tree_.order[i]};
      if (heap_.size() == k_) {
        if (!nearer(candidate, heap_[0])) continue;
        std::pop_heap(heap_.begin(), heap_.end(), nearer);
        heap_.back() = candidate;
      } else {
        heap_.push_back(candidate);
      }
      std::push_heap(heap_.begin(), heap_.end(), nearer);
      if (heap_.size() < k_) continue;
      const double reach =
          std::sqrt(heap_[0].squared_distance) * tree_.inverse_step * kLevelRounding +
          kLevelGridError;
      limit_ = reach * reach * kLevelRounding;
    }
  }

  const Octree& octree_;
  const Octree::Impl& tree_;
  const LevelCells& cells_;
  size_t k_, most_;
  double edge_, limit_ = 0;
  CellNumbers cell_{};
  int64_t shell_ = -1;     // shells 0 ... shell_ are gathered
  bool complete_ = false;  // all points are
  std::vector<uint32_t> points_;
  std::vector<Neighbour> heap_;
};

// The cell of a query; the nearest one of the cube for a query outside.
uint64_t query_code(const Octree::Impl& tree, const Vec3& query, int level) {
  const Vec3 q = (query - tree.cube.origin) * tree.inverse_step;
  uint32_t number[3];
  for (int axis = 0; axis < 3; ++axis)
    number[axis] =
        static_cast<uint32_t>(std::clamp(q[axis], 0.0, 0x1p31 - 1)) >> (kGridBits - level);
  return morton_code(number[0], number[1], number[2]);
}

}  // namespace

void knn_at_level(const Octree& reference, std::span<const Vec3> queries, uint32_t k, int level,
                  Task& task, std::span<Neighbour> out) {
  if (level < 1 || level > kMaxLevel)
    fail(Status::kInvalidArgument, "level %d is outside 1 ... %d", level, kMaxLevel);
  const Octree::Impl& tree = reference.impl();
  if (tree.count == 0 || k == 0) {
    std::fill(out.begin(), out.end(), Neighbour{std::numeric_limits<double>::infinity(), kNoPoint});
    return;
  }
  const LevelCells cells(reference, level, task);
  // Queries by cell: batches of one cell share their gathered points.
  struct Query {
    uint64_t code;
    size_t index;
  };
  if (queries.size() >= kNoPoint)
    fail(Status::kLimit, "at most 2^32 - 2 queries are possible; there are %zu", queries.size());
  Buffer<Query> sorted(queries.size());
  constexpr int kDigitBits = 12;
  const int shift = std::max(0, 3 * level - kDigitBits);
  const auto begins = partition(
      queries.size(), size_t{1} << std::min(3 * level, kDigitBits),
      [shift](const Query& q) { return q.code >> shift; }, task, sorted.data(),
      [&](size_t i) {
        return Query{query_code(tree, queries[i], level), i};
      });
  const auto groups = groups_of(begins.size() - 1, size_t{1} << 14,
                                [&](size_t b) { return begins[b + 1] - begins[b]; });
  parallel_chunks(task, groups.size() - 1, [&](size_t g) {
    std::sort(sorted.data() + begins[groups[g]], sorted.data() + begins[groups[g + 1]],
              [](const Query& a, const Query& b) {
                return a.code < b.code || (a.code == b.code && a.index < b.index);
              });
  });
  constexpr size_t kGrain = 256;
  parallel_for(task, sorted.size(), kGrain, [&](size_t begin, size_t end) {
    CellSearch search(reference, cells, level, k);
    for (size_t i = begin; i < end; ++i) {
      if (i == begin || sorted[i].code != sorted[i - 1].code)
        search.enter(cell_numbers(sorted[i].code));
      if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
      search.find(queries[sorted[i].index], out.subspan(sorted[i].index * k, k));
    }
  });
}

int best_level(const Octree& reference, const Octree& compared, uint32_t k, Task& task) {
  // Formula 4.2 with f linear and t_vois / t_dist = 10^3, in units of t_dist.
  constexpr double kNeighbourCost = 1e3;
  const auto n = static_cast<double>(compared.size());
  double best = std::numeric_limits<double>::infinity();
  int best_level = 1;
  if (reference.size() == 0 || compared.size() == 0) return best_level;
  for (int level = 1; level <= kMaxLevel; ++level) {
    const auto cells1 = compared.cells(level, task), cells2 = reference.cells(level, task);
    size_t alone = 0,
           at = 0;  // cells of the compared cloud without a homologue of at least k points
    for (const auto& cell : cells1) {
      while (at < cells2.size() && cells2[at].code < cell.code) ++at;
      alone += at == cells2.size() || cells2[at].code != cell.code || cells2[at].count < k;
    }
    const double mean = static_cast<double>(reference.size()) / static_cast<double>(cells2.size());
    const double search = kNeighbourCost * static_cast<double>(alone);
    if (search > best) break;  // it grows with the level, so no deeper one can be better
    const double time = n * mean * (3 + std::log(mean)) + search;
    if (time < best) {
      best = time;
      best_level = level;
    }
  }
  return best_level;
}

}  // namespace jalon
