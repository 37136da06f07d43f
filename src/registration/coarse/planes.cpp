// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/planes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr double kPlanesReach = 1.8;  // cells: the eight around one on a plane
constexpr double kSeedVariation = 0.01;
constexpr double kPlanesSameFacing = 0.94;  // cosine, 20 degrees: normals of single cells
constexpr double kPlanesOffPlane = 0.4;     // cells
constexpr size_t kPlanesLeastCells = 20;
constexpr double kCoplanarFacing = 0.9986;  // cosine, 3 degrees
constexpr double kCoplanarOffset = 0.5;     // cells, at the other's centroid

struct Region {
  Moments moments;
  Plane plane;
};

class RegionGrower {
 public:
  RegionGrower(const CoarseSurface& surface, Task& task)
      : s_(surface), near_(s_.size()), label_(s_.size()) {
    constexpr size_t kGrain = 256;
    parallel_for(task, s_.size(), kGrain, [&](size_t begin, size_t end) {
      std::vector<Neighbour> near;
      for (size_t i = begin; i < end; ++i) {
        s_.tree->radius(s_.points[i], kPlanesReach * s_.cell_m, near);
        for (const Neighbour& n : near) near_[i].push_back(n.index);
      }
    });
  }

  std::vector<Region> grow(Task& task) {
    std::vector<uint32_t> seeds(s_.size());
    std::iota(seeds.begin(), seeds.end(), 0u);
    std::stable_sort(seeds.begin(), seeds.end(),
                     [&](uint32_t a, uint32_t b) { return s_.variation[a] < s_.variation[b]; });
    std::vector<Region> out;
    for (size_t k = 0; k < seeds.size() && s_.variation[seeds[k]] <= kSeedVariation; ++k) {
      if (k % 1024 == 0)
        task.checkpoint(static_cast<double>(k) / static_cast<double>(seeds.size()));
      if (label_[seeds[k]]) continue;
      Region region = grown(seeds[k]);
      if (region.moments.n >= kPlanesLeastCells) out.push_back(region);
    }
    return out;
  }

 private:
  bool belongs(uint32_t i, const Plane& plane) const {
    return std::abs(dot(s_.normals[i], plane.normal)) >= kPlanesSameFacing &&
           std::abs(plane.distance(s_.points[i])) <= kPlanesOffPlane * s_.cell_m;
  }

  // The plane is fitted anew whenever the region has doubled.
  Region grown(uint32_t seed) {
    Region region;
    region.moments.reference = s_.points[seed];
    region.plane = {s_.normals[seed], dot(s_.normals[seed], s_.points[seed])};
    std::vector<uint32_t> queue{seed};
    label_[seed] = 1;
    region.moments.add(s_.points[seed]);
    constexpr size_t kFirstFit = 8;
    size_t next_fit = kFirstFit;
    for (size_t head = 0; head < queue.size(); ++head)
      for (const uint32_t k : near_[queue[head]]) {
        if (label_[k] || !belongs(k, region.plane)) continue;
        label_[k] = 1;
        queue.push_back(k);
        region.moments.add(s_.points[k]);
        if (region.moments.n < next_fit) continue;
        fit(region);
        next_fit *= 2;
      }
    fit(region);
    return region;
  }

  static void fit(Region& region) {
    if (region.moments.n < 3) return;
    const Vec3 normal = symmetric_eigen(region.moments.covariance()).vectors[0];
    region.plane = {normal, dot(normal, region.moments.centroid())};
  }

  const CoarseSurface& s_;
  std::vector<std::vector<uint32_t>> near_;
  std::vector<uint8_t> label_;
};

bool is_coplanar(const CoarsePlane& plane, const Region& region, double cell_m) {
  return std::abs(dot(plane.plane.normal, region.plane.normal)) >= kCoplanarFacing &&
         std::abs(plane.plane.distance(region.moments.centroid())) <= kCoplanarOffset * cell_m;
}

}  // namespace

std::vector<CoarsePlane> coarse_planes(const CoarseSurface& surface, size_t most, Task& task) {
  std::vector<Region> regions = RegionGrower(surface, task).grow(task);
  std::stable_sort(regions.begin(), regions.end(),
                   [](const Region& a, const Region& b) { return a.moments.n > b.moments.n; });
  std::vector<CoarsePlane> out;
  for (const Region& region : regions) {
    const auto same = std::find_if(out.begin(), out.end(), [&](const CoarsePlane& plane) {
      return is_coplanar(plane, region, surface.cell_m);
    });
    if (same == out.end()) out.push_back({region.plane, region.moments.n});
    else same->cells += region.moments.n;
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const CoarsePlane& a, const CoarsePlane& b) { return a.cells > b.cells; });
  if (out.size() > most) out.resize(most);
  return out;
}

}  // namespace jalon
