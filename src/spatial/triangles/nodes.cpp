// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/triangles/nodes.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"

namespace jalon::triangle_tree {

namespace {

constexpr int kBins = 16;  // Wald 2007: more gain nothing that can be measured
constexpr uint32_t kSubtreeSize =
    16384;  // below it a subtree is the work of one thread (about 10 ms)
constexpr size_t kBinningGrain = 16384;
constexpr uint32_t kSubtreeMark =
    ~uint32_t{0};  // count of a child that stands for a subtree still to be built

/// Triangles order[first, first + count) and their box.
struct Range {
  uint32_t first = 0, count = 0;
  FloatBox box;
};

/// A subtree still to be built.
struct Job {
  Range range;
  int depth = 0;
};

struct Bin {
  FloatBox box;
  uint32_t count = 0;
  void add(const Bin& b) {
    box.add(b.box);
    count += b.count;
  }
};

/// Where twice the centres of a range lie, cut into bins along each axis.
struct Bins {
  std::array<std::array<Bin, kBins>, 3> bin;
  Bins& operator+=(const Bins& b) {
    for (size_t a = 0; a < 3; ++a)
      for (size_t i = 0; i < kBins; ++i) bin[a][i].add(b.bin[a][i]);
    return *this;
  }
};

struct CentreBox {
  FloatBox box;
  CentreBox& operator+=(const CentreBox& b) {
    box.add(b.box);
    return *this;
  }
};

struct Split {
  int axis = -1;     ///< -1: by count
  int last_bin = 0;  ///< the last bin of the left side
};

class Builder {
 public:
  Builder(std::span<const FloatBox> boxes, uint32_t leaf_size, uint32_t at_once,
          std::vector<uint32_t>& order, Task& task)
      : boxes_(boxes), leaf_size_(leaf_size), at_once_(at_once), order_(order), task_(task) {}

  /// Node of a range of more than a leaf's triangles with all below it; gives its index in nodes. With jobs, ranges
  /// of at most kSubtreeSize are put there instead of being built.
  uint32_t build(const Range& range, int depth, std::vector<Node>& nodes, std::vector<Job>* jobs) {
    Range parts[kWidth];
    const uint32_t width = split_into_parts(range, depth, parts);
    const auto index = static_cast<uint32_t>(nodes.size());
    nodes.emplace_back();
    for (uint32_t i = 0; i < kWidth; ++i) {
      const FloatBox box = i < width ? parts[i].box : FloatBox{};
      for (size_t a = 0; a < 3; ++a) {
        nodes[index].bounds[2 * a][i] = box.min[a];
        nodes[index].bounds[2 * a + 1][i] = box.max[a];
      }
      uint32_t child = 0, count = 0;
      if (i < width) {
        child = parts[i].first;
        count = parts[i].count;
        if (count > leaf_size_ && jobs != nullptr && count <= kSubtreeSize) {
          child = static_cast<uint32_t>(jobs->size());
          count = kSubtreeMark;
          jobs->push_back({parts[i], depth + 1});
        } else if (count > leaf_size_) {
          child = build(parts[i], depth + 1, nodes, jobs);
          count = 0;
        }
      }
      nodes[index].child[i] = child;
      nodes[index].count[i] = count;
    }
    return index;
  }

  Range range_of(uint32_t first, uint32_t count) {
    const auto map = [&](size_t begin, size_t end) {
      CentreBox sum;
      for (size_t i = begin; i < end; ++i) sum.box.add(boxes_[order_[first + i]]);
      return sum;
    };
    return {first, count, reduce(count, CentreBox{}, map).box};
  }

 private:
  /// Splits the largest part in two until there are four, or nothing is left to split.
  uint32_t split_into_parts(const Range& range, int depth, Range (&parts)[kWidth]) {
    parts[0] = range;
    uint32_t width = 1;
    while (width < kWidth) {
      uint32_t chosen = kWidth;
      for (uint32_t i = 0; i < width; ++i)
        if (parts[i].count > leaf_size_ &&
            (chosen == kWidth || parts[i].box.half_area() > parts[chosen].box.half_area()))
          chosen = i;
      if (chosen == kWidth) break;
      const auto [left, right] = split(parts[chosen], depth);
      parts[chosen] = left;
      parts[width++] = right;
    }
    return width;
  }

  std::pair<Range, Range> split(const Range& range, int depth) {
    const FloatBox centres = centre_box(range);
    Split best;
    if (depth < kMaxBinnedDepth) best = best_split(range, centres);
    uint32_t left = range.count / 2;
    if (best.axis >= 0) left = partition(range, centres, best);
    return {range_of(range.first, left), range_of(range.first + left, range.count - left)};
  }

  FloatBox centre_box(const Range& range) {
    const auto map = [&](size_t begin, size_t end) {
      CentreBox sum;
      for (size_t i = begin; i < end; ++i) {
        const FloatBox& box = boxes_[order_[range.first + i]];
        FloatBox centre;
        for (size_t a = 0; a < 3; ++a) centre.min[a] = centre.max[a] = box.min[a] + box.max[a];
        sum.box.add(centre);
      }
      return sum;
    };
    return reduce(range.count, CentreBox{}, map).box;
  }

  static float bin_scale(const FloatBox& centres, size_t axis) {
    const float width = centres.max[axis] - centres.min[axis];
    return width > 0 ? kBins / width : 0;
  }
  static int bin_of(const FloatBox& box, const FloatBox& centres, float scale, size_t axis) {
    const float b = (box.min[axis] + box.max[axis] - centres.min[axis]) * scale;
    return b < kBins - 1 ? static_cast<int>(b) : kBins - 1;
  }

  float tests(uint32_t count) const {
    return static_cast<float>((count + at_once_ - 1) / at_once_);
  }

  /// Least sum of (half area x tests of triangles) of both sides; ties go to the lower axis and bin.
  Split best_split(const Range& range, const FloatBox& centres) {
    float scale[3];
    for (size_t a = 0; a < 3; ++a) scale[a] = bin_scale(centres, a);
    const Bins bins = reduce(range.count, Bins{}, [&](size_t begin, size_t end) {
      Bins sum;
      for (size_t i = begin; i < end; ++i) {
        const FloatBox& box = boxes_[order_[range.first + i]];
        for (size_t a = 0; a < 3; ++a) {
          Bin& bin = sum.bin[a][static_cast<size_t>(bin_of(box, centres, scale[a], a))];
          bin.box.add(box);
          ++bin.count;
        }
      }
      return sum;
    });
    Split best;
    float best_cost = std::numeric_limits<float>::infinity();
    for (size_t a = 0; a < 3; ++a) {
      if (!(scale[a] > 0) || !(scale[a] < std::numeric_limits<float>::infinity())) continue;
      std::array<float, kBins> right_cost{};
      Bin side;
      for (size_t i = kBins - 1; i > 0; --i) {
        side.add(bins.bin[a][i]);
        right_cost[i] = side.count == 0 ? -1 : side.box.half_area() * tests(side.count);
      }
      side = {};
      for (size_t i = 0; i + 1 < kBins; ++i) {
        side.add(bins.bin[a][i]);
        if (side.count == 0 || right_cost[i + 1] < 0) continue;
        const float cost = side.box.half_area() * tests(side.count) + right_cost[i + 1];
        if (cost < best_cost) {
          best_cost = cost;
          best = {static_cast<int>(a), static_cast<int>(i)};
        }
      }
    }
    return best;
  }

  uint32_t partition(const Range& range, const FloatBox& centres, const Split& split) {
    const auto axis = static_cast<size_t>(split.axis);
    const float scale = bin_scale(centres, axis);
    const auto begin = order_.begin() + range.first;
    const auto middle = std::partition(begin, begin + range.count, [&](uint32_t i) {
      return bin_of(boxes_[i], centres, scale, axis) <= split.last_bin;
    });
    return static_cast<uint32_t>(middle - begin);
  }

  /// Sum over the range: in parallel where it is long. Sums of boxes and counts are exact, so the cuts change
  /// nothing.
  template <class T, class F>
  T reduce(uint32_t count, T zero, F&& map) {
    if (count <= kSubtreeSize) return map(0, count);
    return parallel_reduce(task_, count, kBinningGrain, zero, map);
  }

  std::span<const FloatBox> boxes_;
  const uint32_t leaf_size_, at_once_;
  std::vector<uint32_t>& order_;
  Task& task_;
};

/// Builds the subtrees in parallel and puts them behind the top nodes, in the order of the jobs.
void build_subtrees(Builder& builder, std::vector<Node>& nodes, std::span<const Job> jobs,
                    Task& task) {
  std::vector<std::vector<Node>> built(jobs.size());
  parallel_chunks(task, jobs.size(), [&](size_t j) {
    builder.build(jobs[j].range, jobs[j].depth, built[j], nullptr);
  });
  std::vector<uint32_t> base(jobs.size());
  size_t total = nodes.size();
  for (size_t j = 0; j < jobs.size(); ++j) {
    base[j] = static_cast<uint32_t>(total);
    total += built[j].size();
  }
  for (Node& node : nodes)
    for (uint32_t i = 0; i < kWidth; ++i)
      if (node.count[i] == kSubtreeMark) {
        node.child[i] = base[node.child[i]];
        node.count[i] = 0;
      }
  nodes.resize(total);
  parallel_chunks(task, jobs.size(), [&](size_t j) {
    for (size_t k = 0; k < built[j].size(); ++k) {
      Node node = built[j][k];
      for (uint32_t i = 0; i < kWidth; ++i)
        if (node.count[i] == 0) node.child[i] += base[j];
      nodes[base[j] + k] = node;
    }
  });
}

}  // namespace

Nodes build_nodes(std::span<const FloatBox> boxes, uint32_t leaf_size, uint32_t at_once,
                  Task& task) {
  Nodes out;
  if (boxes.empty()) return out;
  const auto n = static_cast<uint32_t>(boxes.size());
  out.order.resize(n);
  std::iota(out.order.begin(), out.order.end(), 0u);
  Builder builder(boxes, leaf_size, at_once, out.order, task);
  std::vector<Job> jobs;
  const Range all = builder.range_of(0, n);
  {
    const ProgressSpan span(task, 0, 0.4);
    builder.build(all, 0, out.nodes, n > kSubtreeSize ? &jobs : nullptr);
  }
  const ProgressSpan span(task, 0.4, 1);
  if (!jobs.empty()) build_subtrees(builder, out.nodes, jobs, task);
  return out;
}

}  // namespace jalon::triangle_tree
