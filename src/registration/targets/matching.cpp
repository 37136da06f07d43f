// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/matching.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "registration/maximum_cliques.h"

namespace jalon {

namespace {

constexpr double kSigmas = 4;          // of a distance's difference: one of 16000 good ones is lost
constexpr size_t kMostNodes = 10'000;  // 100 by 100 targets
constexpr size_t kMostScaled = 1'600;  // 40 by 40, whose ratios fit in memory
constexpr size_t kMostWays = 64;       // a cube of targets has 48
constexpr double kMostScale = 1000;    // either way: millimetres for metres
constexpr size_t kWindowsOfAnEdge = 64;  // an edge with a looser ratio says nothing about the scale

// Two pairs: the difference of their distances, or the logarithm of their ratio, and how far it may be off.
struct Edge {
  size_t a, b;
  double ratio, tolerance;
};

double variance_along(const Square<3>& c, const Vec3& u) {
  double sum = 0;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j)
      sum += u[static_cast<int>(i)] * c[3 * i + j] * u[static_cast<int>(j)];
  return sum;
}

// Distances of all targets of one side from each other, with their variances.
class Distances {
 public:
  Distances(std::span<const Target> targets, double sigma_m)
      : n_(targets.size()), d_(n_ * n_), v_(n_ * n_) {
    for (size_t i = 0; i < n_; ++i)
      for (size_t j = 0; j < n_; ++j) {
        if (i == j) continue;
        const Vec3 apart = targets[j].xyz - targets[i].xyz;
        const Vec3 u = normalized(apart);
        d_[i * n_ + j] = norm(apart);
        v_[i * n_ + j] = variance_along(covariance_of(targets[i], sigma_m), u) +
                         variance_along(covariance_of(targets[j], sigma_m), u);
      }
  }
  double length(size_t i, size_t j) const { return d_[i * n_ + j]; }
  double variance(size_t i, size_t j) const { return v_[i * n_ + j]; }

 private:
  size_t n_;
  std::vector<double> d_, v_;
};

class Matcher {
 public:
  Matcher(const TargetSets& sets, std::span<const IndexPair> named, const TargetSettings& setting,
          Task& task)
      : setting_(setting),
        task_(task),
        nodes_(named.begin(), named.end()),
        named_(named.size()),
        reference_(sets.reference, setting.sigma_m),
        moving_(sets.moving, setting.sigma_m) {
    std::vector<bool> to(sets.reference.size()), from(sets.moving.size());
    for (const IndexPair& pair : named) to[pair.reference] = from[pair.moving] = true;
    for (size_t i = 0; i < to.size(); ++i)
      for (size_t j = 0; j < from.size(); ++j)
        if (!to[i] && !from[j] && (sets.reference[i].name.empty() || sets.moving[j].name.empty()))
          nodes_.push_back({i, j});
  }

  Matching run() {
    const size_t most = setting_.with_scale() ? kMostScaled : kMostNodes;
    if (nodes_.size() > most)
      fail(Status::kLimit,
           "%zu pairs of unnamed targets are possible; distances tell at most %zu apart: name them",
           nodes_.size(), most);
    return setting_.with_scale() ? by_ratios() : by_lengths();
  }

 private:
  size_t least() const {
    return std::max<size_t>(3, best_) - std::min(named_, std::max<size_t>(3, best_));
  }

  // At which difference or ratio of their distances two pairs agree, if they can.
  std::optional<Edge> agreement(size_t a, size_t b) const {
    const IndexPair &p = nodes_[a], &q = nodes_[b];
    if (p.reference == q.reference || p.moving == q.moving) return std::nullopt;
    const double r = reference_.length(p.reference, q.reference),
                 m = moving_.length(p.moving, q.moving);
    const double vr = reference_.variance(p.reference, q.reference),
                 vm = moving_.variance(p.moving, q.moving);
    const double given = setting_.match_tolerance_m;
    if (!setting_.with_scale()) {
      const Edge edge{a, b, r - m, given > 0 ? given : kSigmas * std::sqrt(vr + vm)};
      if (!(std::fabs(edge.ratio) <= edge.tolerance)) return std::nullopt;
      return edge;
    }
    const double sigmas = kSigmas * std::sqrt(vr / (r * r) + vm / (m * m));
    const Edge edge{a, b, std::log(r / m), given > 0 ? given / r : sigmas};
    if (!(std::fabs(edge.ratio) <= std::log(kMostScale))) return std::nullopt;
    return edge;
  }

  Matching by_lengths() {
    PairGraph graph(nodes_.size());
    for (size_t a = 0; a < nodes_.size(); ++a) {
      task_.checkpoint(0);
      for (size_t b = a + 1; b < nodes_.size(); ++b)
        if (agreement(a, b)) graph.join(a, b);
    }
    return search(graph);
  }

  // The known pairs stand; the others must agree with each of them.
  Matching search(const PairGraph& graph) {
    std::vector<uint64_t> candidates(graph.words());
    for (size_t i = named_; i < nodes_.size(); ++i) candidates[i / 64] |= uint64_t{1} << (i % 64);
    for (size_t k = 0; k < named_; ++k)
      for (size_t w = 0; w < candidates.size(); ++w) candidates[w] &= graph.row(k)[w];
    const Cliques cliques = maximum_cliques(graph, candidates, least(), kMostWays, task_);
    Matching out{{}, cliques.complete};
    for (const auto& clique : cliques.all) {
      std::vector<IndexPair> way(nodes_.begin(), nodes_.begin() + static_cast<ptrdiff_t>(named_));
      for (const size_t node : clique) way.push_back(nodes_[node]);
      out.ways.push_back(std::move(way));
    }
    return out;
  }

  // Windows of the scale, the fullest first, while they can hold a larger set than the best: k pairs make
  // k (k - 1) / 2 edges.
  Matching by_ratios() {
    std::vector<Edge> edges;
    double width = INFINITY;
    for (size_t a = 0; a < nodes_.size(); ++a) {
      task_.checkpoint(0);
      for (size_t b = a + 1; b < nodes_.size(); ++b)
        if (const auto edge = agreement(a, b)) {
          edges.push_back(*edge);
          width = std::min(width, edge->tolerance);
        }
    }
    if (edges.empty()) return {};
    std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
      return x.ratio != y.ratio ? x.ratio < y.ratio : x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    width = std::max(width, 2 * std::log(kMostScale) / (1 << 20));
    return by_windows(edges, width);
  }

  struct Window {
    int64_t at;
    size_t edges;
  };

  std::vector<Window> windows_of(const std::vector<Edge>& edges, double width) const {
    const int64_t half = static_cast<int64_t>(std::log(kMostScale) / width) + 1;
    std::vector<int32_t> steps(static_cast<size_t>(2 * half + 2));
    for (const Edge& e : edges) {
      const double reach = std::min(e.tolerance, width * static_cast<double>(kWindowsOfAnEdge) / 2);
      const auto place = [&](double ratio) {
        return std::clamp<int64_t>(static_cast<int64_t>(std::llround(ratio / width)) + half, 0,
                                   2 * half);
      };
      ++steps[static_cast<size_t>(place(e.ratio - reach))];
      --steps[static_cast<size_t>(place(e.ratio + reach) + 1)];
    }
    std::vector<Window> out;
    int64_t count = 0;
    for (int64_t w = 0; w <= 2 * half; ++w) {
      count += steps[static_cast<size_t>(w)];
      if (count >= 3) out.push_back({w - half, static_cast<size_t>(count)});
    }
    std::sort(out.begin(), out.end(), [](const Window& x, const Window& y) {
      return x.edges != y.edges ? x.edges > y.edges : x.at < y.at;
    });
    return out;
  }

  Matching by_windows(const std::vector<Edge>& edges, double width) {
    Matching out;
    for (const Window& window : windows_of(edges, width)) {
      if (best_ * (best_ - 1) / 2 > window.edges && best_ > 0) break;
      task_.checkpoint(0);
      const double at = static_cast<double>(window.at) * width;
      PairGraph graph(nodes_.size());
      for (const Edge& e : edges)
        if (std::fabs(e.ratio - at) <= e.tolerance + width / 2) graph.join(e.a, e.b);
      Matching here = search(graph);
      if (here.ways.empty()) continue;
      if (here.ways[0].size() > best_) {
        best_ = here.ways[0].size();
        out = {};
      }
      out.complete = out.complete && here.complete;
      for (auto& way : here.ways)
        if (std::find(out.ways.begin(), out.ways.end(), way) == out.ways.end())
          out.ways.push_back(std::move(way));
      if (out.ways.size() > kMostWays) break;
    }
    return out;
  }

  const TargetSettings& setting_;
  Task& task_;
  std::vector<IndexPair> nodes_;
  size_t named_;
  size_t best_ = 0;
  Distances reference_, moving_;
};

}  // namespace

Matching match_by_distances(const TargetSets& sets, std::span<const IndexPair> named,
                            const TargetSettings& setting, Task& task) {
  return Matcher(sets, named, setting, task).run();
}

}  // namespace jalon
