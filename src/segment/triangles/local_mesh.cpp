// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/local_mesh.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "base/parallel.h"
#include "geometry/growing_delaunay.h"
#include "geometry/plane.h"

namespace jalon {

namespace {

constexpr double kSearchInSpacings = 3;     // the upper end of "2 to 3 point spacings"
constexpr double kStarGridShare = 0x1p-22;  // snapping step of a star as a share of its radius
constexpr size_t kStarPointsPerChunk = 2048;
constexpr size_t kStarRun = 64;  // points that share an entry of the index of stars

using Corners = std::array<uint32_t, 3>;

Corners ascending(uint32_t a, uint32_t b, uint32_t c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  return {a, b, c};
}

// Corners of a triangle but the point that it is listed at, ascending.
using Others = std::array<uint32_t, 2>;

// Stars of consecutive points, as the search comes by them.
struct StarBatch {
  size_t first_point = 0;
  std::vector<uint32_t> first;  ///< places in triangles, one more than points
  std::vector<Others> triangles;
};

// The triangles about each point: left in their batches, since a second copy would be the method's peak of memory.
struct Stars {
  std::vector<StarBatch> batches;      ///< in the order of the points
  std::vector<uint32_t> batch_of_run;  ///< that has the first point of each run of kStarRun
  void index(size_t points) {
    uint32_t batch = 0;
    for (size_t first = 0; first < points; first += kStarRun) {
      while (batch + 1 < batches.size() && batches[batch + 1].first_point <= first) ++batch;
      batch_of_run.push_back(batch);
    }
  }
  std::span<const Others> of(uint32_t point) const {
    size_t b = batch_of_run[point / kStarRun];
    while (b + 1 < batches.size() && batches[b + 1].first_point <= point) ++b;
    const StarBatch& batch = batches[b];
    const size_t own = point - batch.first_point;
    return {batch.triangles.data() + batch.first[own], batch.first[own + 1] - batch.first[own]};
  }
  bool has(uint32_t point, const Corners& triangle) const {
    Others others;
    size_t count = 0;
    for (const uint32_t corner : triangle)
      if (corner != point) others[count++] = corner;
    const auto own = of(point);
    return std::any_of(own.begin(), own.end(),
                       [&](const Others& o) { return o[0] == others[0] && o[1] == others[1]; });
  }
};

// Makes the star of one point after the other.
class StarMaker {
 public:
  StarMaker(const Octree& tree, const MeshRule& rule) : tree_(tree), rule_(rule) {}

  /// Appends the triangles; the roughness of the neighbourhood.
  float make(uint32_t centre, std::span<const uint32_t> neighbours, double squared_radius,
             std::vector<Others>& out) {
    PlaneFit fit;
    gather(centre, neighbours);
    Moments moments;
    moments.reference = tree_.local(centre);
    for (const uint32_t point : points_) moments.add(tree_.local(point));
    const double radius = std::sqrt(squared_radius);
    if (!(radius > 0) || !fit_plane(moments, fit)) return INFINITY;
    flat_.clear();
    for (const uint32_t point : points_) {
      const Vec3 d = tree_.local(point) - fit.centroid;
      flat_.push_back({dot(d, fit.axis_u), dot(d, fit.axis_v)});
    }
    const auto own = std::lower_bound(points_.begin(), points_.end(), centre) - points_.begin();
    delaunay_.start(flat_, radius * kStarGridShare, static_cast<uint32_t>(own));
    const double spacing =
        radius * std::sqrt(std::numbers::pi / static_cast<double>(points_.size()));
    const double longest = rule_.search_m > 0 ? rule_.search_m : kSearchInSpacings * spacing;
    for (const auto& t : delaunay_.triangles()) add(t, centre, longest, out);
    return static_cast<float>(fit.sigma);
  }

 private:
  // In the order of the tree, so that points on one circle are split alike in all stars.
  void gather(uint32_t centre, std::span<const uint32_t> neighbours) {
    points_.clear();
    bool has_centre = false;
    for (const uint32_t point : neighbours) {
      if (point == kNoPoint) continue;
      points_.push_back(point);
      has_centre |= point == centre;
    }
    if (!has_centre) points_.push_back(centre);
    std::sort(points_.begin(), points_.end());
  }

  void add(const std::array<uint32_t, 3>& t, uint32_t centre, double longest,
           std::vector<Others>& out) const {
    const uint32_t a = points_[t[0]], b = points_[t[1]], c = points_[t[2]];
    if (a != centre && b != centre && c != centre) return;
    const Vec3 pa = tree_.local(a), pb = tree_.local(b), pc = tree_.local(c);
    if (std::max({norm(pb - pa), norm(pc - pb), norm(pa - pc)}) > longest) return;
    const Corners sorted = ascending(a, b, c);
    if (sorted[0] == centre) out.push_back({sorted[1], sorted[2]});
    else out.push_back({sorted[0], sorted[1] == centre ? sorted[2] : sorted[1]});
  }

  const Octree& tree_;
  const MeshRule& rule_;
  std::vector<uint32_t> points_;
  std::vector<Vec2> flat_;
  GrowingDelaunay delaunay_;
};

Stars make_stars(const Octree& tree, const MeshRule& rule, std::vector<float>& roughness,
                 Task& task) {
  const auto k = static_cast<uint32_t>(std::min<size_t>(rule.k, tree.size()));
  Stars stars;
  std::mutex mutex;
  tree.for_each_knn(k, task, [&](const Octree::Batch& b) {
    StarMaker maker(tree, rule);
    StarBatch own{b.first, {0}, {}};
    for (size_t i = 0; i < b.count; ++i) {
      const size_t point = b.first + i;
      const double squared = static_cast<double>(b.squared[i * k + k - 1]);
      roughness[point] = maker.make(static_cast<uint32_t>(point), {b.neighbours + i * k, k},
                                    squared, own.triangles);
      own.first.push_back(static_cast<uint32_t>(own.triangles.size()));
    }
    own.triangles.shrink_to_fit();
    const std::lock_guard<std::mutex> lock(mutex);
    stars.batches.push_back(std::move(own));
  });
  std::sort(stars.batches.begin(), stars.batches.end(),
            [](const StarBatch& a, const StarBatch& b) { return a.first_point < b.first_point; });
  stars.index(tree.size());
  return stars;
}

using TriangleParts = std::vector<std::vector<Corners>>;

// Triangles that enough stars have, each from the star of its first corner that has it; in parts, for the stars to go
// before these become one list.
TriangleParts agreed_triangles(const Stars& stars, size_t n, uint32_t least_stars, Task& task) {
  TriangleParts parts((n + kStarPointsPerChunk - 1) / kStarPointsPerChunk);
  parallel_for(task, n, kStarPointsPerChunk, [&](size_t begin, size_t end) {
    auto& part = parts[begin / kStarPointsPerChunk];
    for (size_t point = begin; point < end; ++point)
      for (const Others& o : stars.of(static_cast<uint32_t>(point))) {
        const Corners t = ascending(static_cast<uint32_t>(point), o[0], o[1]);
        uint32_t seen = 0, first = kNoPoint;
        for (const uint32_t corner : t) {
          if (!stars.has(corner, t)) continue;
          ++seen;
          if (first == kNoPoint) first = corner;
        }
        if (seen >= least_stars && first == point) part.push_back(t);
      }
  });
  return parts;
}

std::vector<Corners> joined(TriangleParts parts) {
  std::vector<Corners> triangles;
  size_t count = 0;
  for (const auto& part : parts) count += part.size();
  triangles.reserve(count);
  for (auto& part : parts) {
    triangles.insert(triangles.end(), part.begin(), part.end());
    part = {};
  }
  return triangles;
}

}  // namespace

LocalMesh local_mesh(const Octree& tree, const MeshRule& rule, Task& task) {
  const size_t n = tree.size();
  LocalMesh mesh;
  mesh.roughness_m.assign(n, INFINITY);
  TriangleParts agreed;
  {
    const Stars stars = make_stars(tree, rule, mesh.roughness_m, task);
    agreed = agreed_triangles(stars, n, rule.least_stars, task);
  }
  mesh.triangles = joined(std::move(agreed));
  mesh.first.assign(n + 1, 0);
  for (const Corners& t : mesh.triangles)
    for (const uint32_t corner : t) ++mesh.first[corner + 1];
  for (size_t i = 0; i < n; ++i) mesh.first[i + 1] += mesh.first[i];
  mesh.at_point.resize(mesh.first[n]);
  std::vector<uint32_t> next(mesh.first.begin(), mesh.first.end() - 1);
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (const uint32_t corner : mesh.triangles[t]) mesh.at_point[next[corner]++] = t;
  return mesh;
}

}  // namespace jalon
