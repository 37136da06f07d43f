// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/fast_marching.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

void FrontQueue::push(double time, uint32_t node) {
  heap_.push_back({time, node});
  std::push_heap(heap_.begin(), heap_.end(), [](const Entry& a, const Entry& b) {
    return a.time != b.time ? a.time > b.time : a.node > b.node;
  });
}

FrontQueue::Entry FrontQueue::pop() {
  std::pop_heap(heap_.begin(), heap_.end(), [](const Entry& a, const Entry& b) {
    return a.time != b.time ? a.time > b.time : a.node > b.node;
  });
  const Entry first = heap_.back();
  heap_.pop_back();
  return first;
}

double arrival_time(std::span<AxisStep> axes) {
  std::sort(axes.begin(), axes.end(),
            [](const AxisStep& a, const AxisStep& b) { return a.time < b.time; });
  // Times relative to the earliest, which they may be far above in digits.
  const double origin = axes[0].time;
  double best = axes[0].cost, a = 0, b = 0, c = -1;
  for (size_t d = 0; d < axes.size(); ++d) {
    const double t = axes[d].time - origin, w = 1 / (axes[d].cost * axes[d].cost);
    if (d > 0 && best <= t) break;  // the front was here before it reached this neighbour
    a += w;
    b += w * t;
    c += w * t * t;
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) break;
    best = (b + std::sqrt(discriminant)) / a;
  }
  return origin + best;
}

namespace {

constexpr double kFastMarchingInfinity = std::numeric_limits<double>::infinity();
constexpr uint32_t kNone = 0xffffffffu;
constexpr size_t kFastMarchingGrain = 1 << 14;
constexpr int kStraightSteps = 3;

/// The front of surface_distances.
class SurfaceFront {
 public:
  SurfaceFront(std::span<const double> xyz, const SurfaceCells& cells)
      : xyz_(xyz),
        cells_(cells),
        time_(cells.size(), kFastMarchingInfinity),
        slope_(cells.size()),
        accepted_(cells.size()),
        source_(cells.size(), kNone) {}

  /// The cells within a few steps of the seed's own start with their straight distance: there the front is so curved
  /// that plane waves are off by per cents.
  void start(uint32_t seed, uint32_t cell) {
    std::vector<uint32_t> ring{cell};
    size_t from = 0;
    for (int step = 0; step < kStraightSteps; ++step) {
      const size_t to = ring.size();
      for (; from < to; ++from)
        for (const uint32_t next : cells_.neighbours(ring[from]))
          if (std::find(ring.begin(), ring.end(), next) == ring.end()) ring.push_back(next);
    }
    for (const uint32_t node : ring) {
      const Vec3 away = cells_.centroid(node) - point(seed);
      const double distance = norm(away);
      if (distance >= time_[node]) continue;
      source_[node] = seed;
      set(node, distance, normalized(away));
    }
  }

  void run(double most_m, Task& task) {
    constexpr size_t kBetweenLooks = 4096;
    size_t done = 0;
    while (!queue_.empty()) {
      const FrontQueue::Entry next = queue_.pop();
      if (accepted_[next.node] || next.time > time_[next.node]) continue;
      if (next.time > most_m) break;
      accepted_[next.node] = 1;
      for (const uint32_t p : cells_.neighbours(next.node))
        if (!accepted_[p] && source_[p] == kNone) update(p, next.node);
      if (++done % kBetweenLooks == 0)
        task.checkpoint(static_cast<double>(done) / static_cast<double>(cells_.size()));
    }
  }

  /// Distance of a point from its cell's time and slope.
  double at(uint32_t node, uint32_t i) const {
    if (!accepted_[node]) return kFastMarchingInfinity;
    if (source_[node] != kNone) return norm(point(i) - point(source_[node]));
    return std::max(0.0, time_[node] + dot(slope_[node], point(i) - cells_.centroid(node)));
  }

 private:
  Vec3 point(uint32_t i) const {
    return {xyz_[3 * size_t{i}], xyz_[3 * size_t{i} + 1], xyz_[3 * size_t{i} + 2]};
  }

  void set(uint32_t node, double time, const Vec3& slope) {
    time_[node] = time;
    slope_[node] = slope;
    queue_.push(time, node);
  }

  /// What the newly accepted q does for p: along the edge, and through the triangles with the other accepted cells
  /// that touch both.
  void update(uint32_t p, uint32_t q) {
    const Vec3 at = cells_.centroid(p), u = cells_.centroid(q) - at;
    double best = time_[p];
    Vec3 slope;
    const double length = norm(u);
    if (time_[q] + length < best) {
      best = time_[q] + length;
      slope = length > 0 ? u / -length : slope_[q];
    }
    for (const uint32_t r : cells_.neighbours(p))
      if (r != q && accepted_[r] && cells_.touch(q, r))
        through_triangle(u, cells_.centroid(r) - at, q, r, best, slope);
    if (best < time_[p]) set(p, best, slope);
  }

  /// The plane wave over the triangle of p, q and r: |grad T| = 1 in the span of u = q - p and v = r - p, coming from
  /// between the two.
  void through_triangle(const Vec3& u, const Vec3& v, uint32_t q, uint32_t r, double& best,
                        Vec3& slope) const {
    constexpr double kFlat = 1e-6;  // of the area of a right angle
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
    if (!(det > kFlat * uu * vv)) return;
    // Times relative to that of q; G^-1 = ((vv, -uv), (-uv, uu)) / det.
    const double tr = time_[r] - time_[q];
    const double a = (vv - 2 * uv + uu) / det, b = tr * (uu - uv) / det, c = tr * tr * uu / det - 1;
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return;
    const double t = (b + std::sqrt(discriminant)) / a;
    const double wu = (-vv * t - uv * (tr - t)) / det, wv = (uv * t + uu * (tr - t)) / det;
    if (wu > 0 || wv > 0 || !(time_[q] + t < best)) return;
    best = time_[q] + t;
    slope = u * wu + v * wv;
  }

  std::span<const double> xyz_;
  const SurfaceCells& cells_;
  std::vector<double> time_;
  std::vector<Vec3> slope_;
  std::vector<uint8_t> accepted_;
  std::vector<uint32_t> source_;  ///< the seed of the cells that start with a straight distance
  FrontQueue queue_;
};

}  // namespace

std::vector<double> surface_distances(std::span<const double> xyz, const SurfaceCells& cells,
                                      std::span<const uint32_t> seeds, double most_m, Task& task) {
  std::vector<uint32_t> cell_of(xyz.size() / 3);
  parallel_for(task, cells.size(), kFastMarchingGrain, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c)
      for (const uint32_t i : cells.points(static_cast<uint32_t>(c)))
        cell_of[i] = static_cast<uint32_t>(c);
  });
  SurfaceFront front(xyz, cells);
  for (const uint32_t seed : seeds) front.start(seed, cell_of[seed]);
  front.run(most_m, task);
  std::vector<double> out(cell_of.size());
  parallel_for(task, out.size(), kFastMarchingGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const double distance = front.at(cell_of[i], static_cast<uint32_t>(i));
      out[i] = distance <= most_m ? distance : kFastMarchingInfinity;
    }
  });
  return out;
}

}  // namespace jalon
