// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/triangle_growth.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace jalon {

namespace {

constexpr double kSeedRoughness = 0.5;    // sigma of a seed, in tolerances (as of other seeds)
constexpr double kRegionRoughness = 0.5;  // the same of a finished region
constexpr double kTriangleRefit = 1.1;    // growth after which the plane is fitted anew
constexpr double kNoiseSigmas = 3;        // of a corner, that turn a small triangle
constexpr uint64_t kLeastForSigma = 12;   // points that tell the noise (as in local_surface.cpp)
constexpr size_t kTrianglesPerCheckpoint = 1 << 12;

class TriangleGrower {
 public:
  TriangleGrower(const Octree& tree, const LocalMesh& mesh, const TriangleRule& rule, Task& task)
      : tree_(tree),
        mesh_(mesh),
        rule_(rule),
        task_(task),
        asked_(mesh.triangles.size(), 0),
        spent_(tree.size(), 0) {
    regions_.labels.assign(tree.size(), 0);
  }

  TriangleRegions run() {
    const std::vector<uint32_t> seeds = seeds_by_roughness();
    for (size_t i = 0; i < seeds.size(); ++i) {
      progress_ = static_cast<double>(i) / static_cast<double>(seeds.size());
      if (i % kTrianglesPerCheckpoint == 0) task_.checkpoint(progress_);
      if (regions_.labels[seeds[i]] == 0 && spent_[seeds[i]] == 0) try_seed(seeds[i]);
    }
    return std::move(regions_);
  }

 private:
  std::vector<uint32_t> seeds_by_roughness() const {
    std::vector<uint32_t> seeds;
    for (uint32_t point = 0; point < tree_.size(); ++point)
      if (static_cast<double>(mesh_.roughness_m[point]) <= kSeedRoughness * rule_.tolerance_m &&
          !mesh_.triangles_at(point).empty())
        seeds.push_back(point);
    std::stable_sort(seeds.begin(), seeds.end(), [&](uint32_t a, uint32_t b) {
      return mesh_.roughness_m[a] < mesh_.roughness_m[b];
    });
    return seeds;
  }

  void try_seed(uint32_t seed) {
    ++round_;
    label_ = static_cast<uint32_t>(regions_.planes.size() + 1);
    members_.clear();
    queue_.clear();
    moments_ = {};
    moments_.reference = tree_.local(seed);
    fitted_ = 0;
    PlaneFit fit;
    if (!star_plane(seed, fit)) return;
    plane_ = fit.plane;
    sigma_m_ = rule_.tolerance_m / kNoiseSigmas;  // until the region tells it
    for (const uint32_t t : mesh_.triangles_at(seed)) ask(t);
    for (size_t at = 0; at < queue_.size(); ++at) {
      if ((at + 1) % kTrianglesPerCheckpoint == 0) task_.checkpoint(progress_);
      ask_beside(queue_[at]);
    }
    const bool good = members_.size() >= rule_.least_points && fit_plane(moments_, fit) &&
                      fit.sigma <= kRegionRoughness * rule_.tolerance_m;
    if (good) {
      regions_.planes.push_back(fit.plane);
      return;
    }
    spent_[seed] = 1;
    for (const uint32_t point : members_) {
      regions_.labels[point] = 0;
      spent_[point] = 1;  // it would grow the same region again
    }
  }

  // Through the free corners of a point's triangles.
  bool star_plane(uint32_t seed, PlaneFit& fit) const {
    Moments moments;
    moments.reference = tree_.local(seed);
    for (const uint32_t t : mesh_.triangles_at(seed))
      for (const uint32_t corner : mesh_.triangles[t])
        if (regions_.labels[corner] == 0) moments.add(tree_.local(corner));
    return fit_plane(moments, fit) && fit.sigma <= rule_.tolerance_m;
  }

  // All triangles that share an edge with this one.
  void ask_beside(uint32_t triangle) {
    const auto& t = mesh_.triangles[triangle];
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      for (const uint32_t other : mesh_.triangles_at(a)) {
        const auto& o = mesh_.triangles[other];
        if (other != triangle && (o[0] == b || o[1] == b || o[2] == b)) ask(other);
      }
    }
  }

  void ask(uint32_t triangle) {
    if (asked_[triangle] == round_) return;
    asked_[triangle] = round_;
    const auto& t = mesh_.triangles[triangle];
    for (const uint32_t corner : t) {
      const uint32_t owner = regions_.labels[corner];
      if (owner != 0 && owner != label_) return;
      if (std::fabs(plane_.distance(tree_.local(corner))) > rule_.tolerance_m) return;
    }
    if (!lies_alike(t)) return;
    queue_.push_back(triangle);
    for (const uint32_t corner : t) {
      if (regions_.labels[corner] == label_) continue;
      regions_.labels[corner] = label_;
      members_.push_back(corner);
      moments_.add(tree_.local(corner));
    }
    refit();
  }

  // Noise turns a triangle by its share of the height: on real scans the distance must lead.
  bool lies_alike(const std::array<uint32_t, 3>& t) const {
    const Vec3 a = tree_.local(t[0]), b = tree_.local(t[1]), c = tree_.local(t[2]);
    const Vec3 twice_area = cross(b - a, c - a);
    const double area = norm(twice_area);
    const double height = area / std::max({norm(b - a), norm(c - b), norm(a - c)});
    const double noise = std::atan2(kNoiseSigmas * sigma_m_, height);
    const double limit = std::cos(std::min(1.5707, rule_.angle_rad + noise));
    return std::fabs(dot(twice_area, plane_.normal)) >= limit * area;
  }

  void refit() {
    const auto n = static_cast<double>(moments_.n);
    if (moments_.n < kLeastForSigma || n < kTriangleRefit * static_cast<double>(fitted_)) return;
    PlaneFit fit;
    fitted_ = moments_.n;
    if (!fit_plane(moments_, fit)) return;
    plane_ = fit.plane;
    sigma_m_ = fit.sigma;
  }

  const Octree& tree_;
  const LocalMesh& mesh_;
  const TriangleRule& rule_;
  Task& task_;
  TriangleRegions regions_;
  std::vector<uint32_t> asked_;  ///< by triangle: the last region that asked
  std::vector<uint8_t> spent_;   ///< by point: has been a seed, or part of what was no region
  std::vector<uint32_t> members_, queue_;
  Moments moments_;
  Plane plane_;
  uint64_t fitted_ = 0;
  double sigma_m_ = 0, progress_ = 0;
  uint32_t round_ = 0, label_ = 0;
};

}  // namespace

TriangleRegions grow_triangles(const Octree& tree, const LocalMesh& mesh, const TriangleRule& rule,
                               Task& task) {
  return TriangleGrower(tree, mesh, rule, task).run();
}

}  // namespace jalon
