// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/triangle_growth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <numeric>
#include <utility>

#include "base/serial.h"

namespace jalon {

namespace {

constexpr double kSeedRoughness = 0.5;    // sigma of a seed, in tolerances (as of other seeds)
constexpr double kRegionRoughness = 0.5;  // the same of a finished region
constexpr double kTriangleRefit = 1.1;    // growth after which the plane is fitted anew
constexpr double kNoiseSigmas = 3;        // of a corner, that turn a small triangle
constexpr uint64_t kLeastForSigma = 12;   // points that tell the noise (as in local_surface.cpp)
constexpr size_t kTrianglesPerCheckpoint = 1 << 12;
constexpr size_t kRoughnessPerLook = 1 << 16;
constexpr size_t kRoughnessClasses = 16;  // most of the points have regions after the first few
constexpr int kDigitShift = 17;           // sign, exponent and six bits: steps of 1.6 %

class TriangleGrower {
 public:
  TriangleGrower(const Octree& tree, LocalMesh mesh, const TriangleRule& rule, Task& task)
      : tree_(tree),
        mesh_(std::move(mesh)),
        rule_(rule),
        task_(task),
        asked_(mesh_.triangles.size(), false),
        spent_(tree.size(), false) {
    regions_.labels.assign(tree.size(), 0);
  }

  TriangleRegions run() {
    size_t tried = 0;
    for (const RoughnessClass& c : roughness_classes()) {
      for (const uint32_t seed : seeds_of(c)) {
        if (tried++ % kTrianglesPerCheckpoint == 0) task_.checkpoint(progress_);
        if (is_seed(seed)) try_seed(seed);
      }
      progress_ += static_cast<double>(c.points) / static_cast<double>(tree_.size());
      task_.checkpoint(progress_);
    }
    return std::move(regions_);
  }

 private:
  bool is_seed(uint32_t point) const {
    return regions_.labels[point] == 0 && !spent_[point] && !mesh_.triangles_at(point).empty();
  }

  // Seeds go from smooth to rough. They are sorted class by class, from values of roughness that have about as many
  // points each: most of the later ones belong to regions by then and need not be.
  struct RoughnessClass {
    uint32_t first, last;  ///< digits [first, last)
    size_t points;
  };
  static uint32_t digit_of(float roughness) {
    return std::bit_cast<uint32_t>(roughness) >>
           kDigitShift;  // orders as the numbers do, from 0 up
  }
  std::vector<RoughnessClass> roughness_classes() const {
    std::vector<size_t> counts(size_t{1} << (32 - kDigitShift), 0);
    serial_for(task_, mesh_.roughness_m.size(), kRoughnessPerLook, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i)
        if (smooth(mesh_.roughness_m[i])) ++counts[digit_of(mesh_.roughness_m[i])];
    });
    std::vector<RoughnessClass> classes;
    RoughnessClass next{0, 0, 0};
    for (uint32_t digit = 0; digit < counts.size(); ++digit) {
      next.points += counts[digit];
      next.last = digit + 1;
      if (next.points < tree_.size() / kRoughnessClasses + 1 && next.last < counts.size()) continue;
      classes.push_back(next);
      next = {next.last, next.last, 0};
    }
    return classes;
  }
  bool smooth(float roughness) const {
    return static_cast<double>(roughness) <= kSeedRoughness * rule_.tolerance_m;
  }
  std::vector<uint32_t> seeds_of(const RoughnessClass& c) const {
    std::vector<uint32_t> seeds;
    serial_for(task_, tree_.size(), kRoughnessPerLook, [&](size_t begin, size_t end) {
      for (size_t point = begin; point < end; ++point) {
        const float roughness = mesh_.roughness_m[point];
        const uint32_t digit = digit_of(roughness);
        if (digit >= c.first && digit < c.last && smooth(roughness) &&
            is_seed(static_cast<uint32_t>(point)))
          seeds.push_back(static_cast<uint32_t>(point));
      }
    });
    std::stable_sort(seeds.begin(), seeds.end(), [&](uint32_t a, uint32_t b) {
      return mesh_.roughness_m[a] < mesh_.roughness_m[b];
    });
    return seeds;
  }

  void try_seed(uint32_t seed) {
    label_ = static_cast<uint32_t>(regions_.planes.size() + 1);
    members_.clear();
    queue_.clear();
    refused_.clear();
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
    for (const uint32_t t : queue_) asked_[t] = false;
    for (const uint32_t t : refused_) asked_[t] = false;
    const bool good = members_.size() >= rule_.least_points && fit_plane(moments_, fit) &&
                      fit.sigma <= kRegionRoughness * rule_.tolerance_m;
    if (good) {
      regions_.planes.push_back(fit.plane);
      return;
    }
    spent_[seed] = true;
    for (const uint32_t point : members_) {
      regions_.labels[point] = 0;
      spent_[point] = true;  // it would grow the same region again
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
    if (asked_[triangle]) return;
    asked_[triangle] = true;
    const auto& t = mesh_.triangles[triangle];
    if (!may_join(t)) return refused_.push_back(triangle);
    queue_.push_back(triangle);
    for (const uint32_t corner : t) {
      if (regions_.labels[corner] == label_) continue;
      regions_.labels[corner] = label_;
      members_.push_back(corner);
      moments_.add(tree_.local(corner));
    }
    refit();
  }

  bool may_join(const TriangleCorners& t) const {
    for (const uint32_t corner : t) {
      const uint32_t owner = regions_.labels[corner];
      if (owner != 0 && owner != label_) return false;
      if (std::fabs(plane_.distance(tree_.local(corner))) > rule_.tolerance_m) return false;
    }
    return lies_alike(t);
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
  LocalMesh mesh_;
  const TriangleRule& rule_;
  Task& task_;
  TriangleRegions regions_;
  std::vector<bool> asked_;  ///< by triangle: asked by the region that grows
  std::vector<bool> spent_;  ///< by point: has been a seed, or part of what was no region
  /// May hold most of the cloud: no room beside that.
  std::deque<uint32_t> members_, queue_;
  std::vector<uint32_t> refused_;
  Moments moments_;
  Plane plane_;
  uint64_t fitted_ = 0;
  double sigma_m_ = 0, progress_ = 0;
  uint32_t label_ = 0;
};

}  // namespace

TriangleRegions grow_triangles(const Octree& tree, LocalMesh mesh, const TriangleRule& rule,
                               Task& task) {
  return TriangleGrower(tree, std::move(mesh), rule, task).run();
}

}  // namespace jalon
