// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/local_mesh.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "base/buffer.h"
#include "base/parallel.h"
#include "base/serial.h"
#include "geometry/growing_delaunay.h"
#include "geometry/plane.h"
#include "segment/triangles/packed_star.h"

namespace jalon {

namespace {

constexpr double kSearchInSpacings = 3;     // the upper end of "2 to 3 point spacings"
constexpr double kStarGridShare = 0x1p-22;  // snapping step of a star as a share of its radius
constexpr size_t kStarPointsPerChunk = 2048;
constexpr size_t kTrianglesPerLook = 1 << 16;
constexpr size_t kNumbersPerStar = 8;          // a place and six or seven links
constexpr size_t kMostBlockNumbers = 9 << 20;  // 36 MiB: beyond what allocators keep for themselves
constexpr size_t kStarRun = 64;                // points that share an entry of the index of stars

// Stars of consecutive points, as the search comes by them.
struct StarBatch {
  size_t first_point = 0;
  const uint32_t* first = nullptr;  ///< places in links, one more than points
  const uint32_t* links = nullptr;  ///< packed stars (packed_star.h)
};

// Memory for batches in few large blocks, which go back to the system with the stars: of many small pieces the
// allocator would keep most beside what comes next.
class StarMemory {
 public:
  explicit StarMemory(size_t points)
      : block_(std::min(kMostBlockNumbers, kNumbersPerStar * points)) {}
  // From one thread at a time.
  uint32_t* take(size_t numbers) {
    if (blocks_.empty() || blocks_.back().size() - used_ < numbers) {
      blocks_.emplace_back(std::max(block_, numbers));
      used_ = 0;
    }
    used_ += numbers;
    return blocks_.back().data() + (used_ - numbers);
  }

 private:
  size_t block_, used_ = 0;
  std::vector<Buffer<uint32_t>> blocks_;
};

// The triangles about each point: left in their batches, since a second copy would be the method's peak of memory.
struct Stars {
  StarMemory memory;
  std::vector<StarBatch> batches;      ///< in the order of the points
  std::vector<uint32_t> batch_of_run;  ///< that has the first point of each run of kStarRun
  void index(size_t points) {
    uint32_t batch = 0;
    for (size_t first = 0; first < points; first += kStarRun) {
      while (batch + 1 < batches.size() && batches[batch + 1].first_point <= first) ++batch;
      batch_of_run.push_back(batch);
    }
  }
  std::span<const uint32_t> of(uint32_t point) const {
    size_t b = batch_of_run[point / kStarRun];
    while (b + 1 < batches.size() && batches[b + 1].first_point <= point) ++b;
    const StarBatch& batch = batches[b];
    const size_t own = point - batch.first_point;
    return {batch.links + batch.first[own], batch.first[own + 1] - batch.first[own]};
  }
  bool has(uint32_t point, const TriangleCorners& triangle) const {
    const uint32_t a = triangle[0] == point ? triangle[1] : triangle[0];
    const uint32_t b = triangle[2] == point ? triangle[1] : triangle[2];
    return star_has(of(point), a, b);
  }
};

// Makes the star of one point after the other.
class StarMaker {
 public:
  StarMaker(const Octree& tree, const MeshRule& rule) : tree_(tree), rule_(rule) {}

  /// Appends the triangles; the roughness of the neighbourhood.
  float make(uint32_t centre, std::span<const uint32_t> neighbours, double squared_radius,
             std::vector<uint32_t>& out) {
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
    StarWriter star(out);
    for (const auto& t : delaunay_.triangles()) add(t, centre, longest, star);
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
           StarWriter& star) const {
    const uint32_t a = points_[t[0]], b = points_[t[1]], c = points_[t[2]];
    if (a != centre && b != centre && c != centre) return;
    const Vec3 pa = tree_.local(a), pb = tree_.local(b), pc = tree_.local(c);
    if (std::max({norm(pb - pa), norm(pc - pb), norm(pa - pc)}) > longest) return;
    if (a == centre) star.add(b, c);
    else star.add(a, b == centre ? c : b);
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
  Stars stars{StarMemory(tree.size()), {}, {}};
  std::mutex mutex;
  tree.for_each_knn(k, task, [&](const Octree::Batch& b) {
    StarMaker maker(tree, rule);
    std::vector<uint32_t> first{0}, links;
    for (size_t i = 0; i < b.count; ++i) {
      const size_t point = b.first + i;
      const double squared = static_cast<double>(b.squared[i * k + k - 1]);
      roughness[point] =
          maker.make(static_cast<uint32_t>(point), {b.neighbours + i * k, k}, squared, links);
      first.push_back(static_cast<uint32_t>(links.size()));
    }
    uint32_t* memory = nullptr;
    {
      const std::lock_guard<std::mutex> lock(mutex);
      memory = stars.memory.take(first.size() + links.size());
      stars.batches.push_back({b.first, memory, memory + first.size()});
    }
    std::copy(links.begin(), links.end(), std::copy(first.begin(), first.end(), memory));
  });
  std::sort(stars.batches.begin(), stars.batches.end(),
            [](const StarBatch& a, const StarBatch& b) { return a.first_point < b.first_point; });
  stars.index(tree.size());
  return stars;
}

// Which triangles of its points' stars a chunk keeps, in their order.
struct AgreedPart {
  std::vector<bool> kept;
  size_t count = 0;
};

// Triangles that enough stars have, each from the star of its first corner that has it.
std::vector<AgreedPart> agreed_triangles(const Stars& stars, size_t n, uint32_t least_stars,
                                         Task& task) {
  std::vector<AgreedPart> parts((n + kStarPointsPerChunk - 1) / kStarPointsPerChunk);
  parallel_for(task, n, kStarPointsPerChunk, [&](size_t begin, size_t end) {
    AgreedPart part;
    for (size_t i = begin; i < end; ++i) {
      const auto point = static_cast<uint32_t>(i);
      for_each_pair(stars.of(point), [&](uint32_t a, uint32_t b) {
        const TriangleCorners t = ascending_corners(point, a, b);
        uint32_t seen = 0, first = kNoPoint;
        for (const uint32_t corner : t) {
          if (!stars.has(corner, t)) continue;
          ++seen;
          if (first == kNoPoint) first = corner;
        }
        part.kept.push_back(seen >= least_stars && first == point);
        part.count += part.kept.back();
      });
    }
    parts[begin / kStarPointsPerChunk] = std::move(part);
  });
  return parts;
}

// One list at once: parts of it beside the stars would be the method's peak of memory.
std::vector<TriangleCorners> kept_triangles(const Stars& stars, size_t n,
                                            const std::vector<AgreedPart>& parts, Task& task) {
  std::vector<size_t> first{0};
  for (const AgreedPart& part : parts) first.push_back(first.back() + part.count);
  std::vector<TriangleCorners> triangles(first.back());
  parallel_for(task, n, kStarPointsPerChunk, [&](size_t begin, size_t end) {
    const size_t chunk = begin / kStarPointsPerChunk;
    size_t at = first[chunk], asked = 0;
    for (size_t i = begin; i < end; ++i) {
      const auto point = static_cast<uint32_t>(i);
      for_each_pair(stars.of(point), [&](uint32_t a, uint32_t b) {
        if (parts[chunk].kept[asked++]) triangles[at++] = ascending_corners(point, a, b);
      });
    }
  });
  return triangles;
}

}  // namespace

TriangleCorners ascending_corners(uint32_t a, uint32_t b, uint32_t c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  return {a, b, c};
}

void take_triangles(LocalMesh& mesh, std::vector<TriangleCorners> triangles, size_t points,
                    Task& task) {
  mesh.triangles = std::move(triangles);
  mesh.first.assign(points + 1, 0);
  const size_t count = mesh.triangles.size();
  serial_for(task, count, kTrianglesPerLook, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t)
      for (const uint32_t corner : mesh.triangles[t]) ++mesh.first[corner + 1];
  });
  for (size_t i = 0; i < points; ++i) mesh.first[i + 1] += mesh.first[i];
  mesh.at_point.resize(mesh.first[points]);
  serial_for(task, count, kTrianglesPerLook, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t)
      for (const uint32_t corner : mesh.triangles[t])
        mesh.at_point[mesh.first[corner]++] = static_cast<uint32_t>(t);
  });
  // Each place went on to the end of its point's list, where the next one's begins.
  std::copy_backward(mesh.first.begin(), mesh.first.end() - 1, mesh.first.end());
  mesh.first[0] = 0;
}

LocalMesh local_mesh(const Octree& tree, const MeshRule& rule, Task& task) {
  const size_t n = tree.size();
  LocalMesh mesh;
  mesh.roughness_m.assign(n, INFINITY);
  std::vector<TriangleCorners> triangles;
  {
    const Stars stars = make_stars(tree, rule, mesh.roughness_m, task);
    const auto agreed = agreed_triangles(stars, n, rule.least_stars, task);
    triangles = kept_triangles(stars, n, agreed, task);
  }
  take_triangles(mesh, std::move(triangles), n, task);
  return mesh;
}

}  // namespace jalon
