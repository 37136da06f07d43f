// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/local_models.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <vector>

#include "base/parallel.h"
#include "cloud/neighbour_planes.h"
#include "compare/distance/local_surface.h"
#include "compare/distance/nearest_groups.h"

namespace jalon {

namespace {

// On an evenly sampled surface the nearest point is farther than 3 R, R = 1 / sqrt(pi lambda) by 2.6, in one case of
// e^9 = 8000: a foot farther from its point than that lies beyond the sampled surface.
constexpr double kReachOfSpacing = 3;
// Many more reference points than compared ones: neighbours are looked for where they are needed only.
constexpr size_t kSparse = 8;

// What is asked of the surface around one reference point.
struct Request {
  size_t centre = 0;                     ///< sorted position of the reference point
  std::span<const uint32_t> neighbours;  ///< sorted positions, itself included
  float farthest2 = 0;                   ///< squared distance of the farthest of them, m^2
  std::span<const uint32_t> queries;     ///< sorted positions of compared points
};

struct Work {
  const Octree& reference;
  const Octree& compared;
  const Cloud& compared_cloud;
  const DistanceSettings& settings;
  uint32_t k;
  const DistanceColumns& columns;
  std::atomic<uint64_t>& modelled;
};

// Takes requests one after the other; planes are solved four at a time.
class ModelMaker {
 public:
  explicit ModelMaker(const Work& work)
      : work_(work), step_(work.reference.grid_step()), planes_(work.reference, Write{this}) {}
  ModelMaker(const ModelMaker&) = delete;
  ModelMaker& operator=(const ModelMaker&) = delete;
  ~ModelMaker() { work_.modelled += modelled_; }

  void add(const Request& request) {
    if (request.queries.empty() || request.neighbours.size() < 3) return;
    waiting_[count_++] = request;
    for (const uint32_t query : request.queries) {
      const uint32_t i = work_.compared.order()[query];
      __builtin_prefetch(work_.compared_cloud.xyz().data() + 3 * size_t{i});
      __builtin_prefetch(&work_.columns.distances[i]);
    }
    planes_.add(request.centre, request.neighbours.data(), request.neighbours.size());
    if (count_ == waiting_.size()) count_ = done_ = 0;  // add() has answered them all
  }
  void flush() {
    planes_.flush();
    count_ = done_ = 0;
  }

 private:
  struct Write {
    ModelMaker* maker;
    void operator()(const NeighbourPlane& plane) const { maker->answer(plane); }
  };

  void answer(const NeighbourPlane& plane) {
    const Request& request = waiting_[done_++];
    if (plane.normal == nullptr) return;
    const double farthest = std::sqrt(static_cast<double>(request.farthest2));
    const double spacing = farthest / std::sqrt(static_cast<double>(request.neighbours.size()));
    surface_.set_plane({plane.normal[0], plane.normal[1], plane.normal[2]}, plane.offset * step_,
                       std::min(farthest, kReachOfSpacing * spacing));
    LocalModelKind kind = work_.settings.local_model;
    if (kind != LocalModelKind::kPlane) {
      load_points(request);
      const bool made = kind == LocalModelKind::kQuadric ? surface_.set_quadric(points_)
                                                         : surface_.set_triangles(points_);
      if (!made && kind == LocalModelKind::kDelaunay) return;
      if (!made) kind = LocalModelKind::kPlane;
    }
    const Vec3 centre = work_.reference.cube().origin + work_.reference.local(request.centre);
    for (const uint32_t query : request.queries) measure(kind, centre, query);
  }

  void load_points(const Request& request) {
    const int32_t *x = work_.reference.grid_x(), *y = work_.reference.grid_y(),
                  *z = work_.reference.grid_z();
    const size_t c = request.centre;
    points_.clear();
    for (const uint32_t j : request.neighbours)
      points_.push_back(Vec3{static_cast<double>(x[j] - x[c]), static_cast<double>(y[j] - y[c]),
                             static_cast<double>(z[j] - z[c])} *
                        step_);
  }

  void measure(LocalModelKind kind, const Vec3& centre, uint32_t query) {
    const uint32_t i = work_.compared.order()[query];
    const Vec3 p = work_.compared_cloud.point(i) - centre;
    Vec3 foot;
    const double nearest_m = work_.columns.distances[i];
    const bool found = kind == LocalModelKind::kPlane ? surface_.foot_on_plane(p, foot)
                       : kind == LocalModelKind::kQuadric
                           ? surface_.foot_on_quadric(p, foot)
                           : surface_.foot_on_triangles(p, nearest_m, foot);
    if (!found) return;
    const double distance = norm(p - foot);
    if (!(distance < nearest_m)) return;
    work_.columns.distances[i] = distance;
    work_.columns.set_difference(i, p - foot);
    ++modelled_;
  }

  const Work& work_;
  const double step_;
  NeighbourPlanes<Write> planes_;
  LocalSurface surface_;
  std::vector<Vec3> points_;
  std::array<Request, 4> waiting_;  // NeighbourPlanes answers four at a time
  size_t count_ = 0, done_ = 0;
  uint64_t modelled_ = 0;
};

// Neighbours of every reference point, in the tree's order.
void model_all(const Work& work, const NearestGroups& groups, Task& task) {
  if (work.settings.radius_m > 0) {
    work.reference.for_each_ball(work.settings.radius_m, task, [&](const Octree::BallBatch& batch) {
      ModelMaker maker(work);
      for (size_t i = 0; i < batch.count; ++i) {
        const size_t begin = batch.offsets[i], end = batch.offsets[i + 1];
        const float farthest2 = *std::max_element(batch.squared + begin, batch.squared + end);
        maker.add({batch.first + i,
                   {batch.neighbours + begin, end - begin},
                   farthest2,
                   groups[batch.first + i]});
      }
      maker.flush();
    });
    return;
  }
  work.reference.for_each_knn(work.k, task, [&](const Octree::Batch& batch) {
    ModelMaker maker(work);
    for (size_t i = 0; i < batch.count; ++i) {
      const uint32_t* neighbours = batch.neighbours + i * batch.k;
      size_t n = batch.k;
      while (n > 1 && neighbours[n - 1] == kNoPoint) --n;  // a small cloud fills up the end
      maker.add({batch.first + i,
                 {neighbours, n},
                 batch.squared[i * batch.k + n - 1],
                 groups[batch.first + i]});
    }
    maker.flush();
  });
}

// Neighbours of single places.
class OneNeighbourhood {
 public:
  explicit OneNeighbourhood(const Work& work) : work_(work), maker_(work), found_(work.k) {}

  void model(const Vec3& place, size_t centre, std::span<const uint32_t> queries) {
    size_t n;
    if (work_.settings.radius_m > 0) {
      work_.reference.radius_positions(place, work_.settings.radius_m, found_);
      n = found_.size();
    } else {
      found_.resize(work_.k);
      n = work_.reference.knn_positions(place, work_.k, found_);
    }
    positions_.clear();
    double farthest2 = 0;
    for (size_t j = 0; j < n; ++j) {
      positions_.push_back(found_[j].index);
      farthest2 = std::max(farthest2, found_[j].squared_distance);
    }
    maker_.add({centre, positions_, static_cast<float>(farthest2), queries});
    maker_.flush();
  }

 private:
  const Work& work_;
  ModelMaker maker_;
  std::vector<Neighbour> found_;
  std::vector<uint32_t> positions_;
};

constexpr size_t kLocalModelsGrain = 1024;

void model_used(const Work& work, const NearestGroups& groups, Task& task) {
  parallel_for(task, work.reference.size(), 16 * kLocalModelsGrain, [&](size_t begin, size_t end) {
    OneNeighbourhood one(work);
    for (size_t p = begin; p < end; ++p)
      if (!groups[p].empty())
        one.model(work.reference.cube().origin + work.reference.local(p), p, groups[p]);
  });
}

// 2.3.2 as printed: the neighbourhood of the compared point.
void model_around_points(const Work& work, std::span<const uint32_t> nearest, Task& task) {
  parallel_for(task, nearest.size(), kLocalModelsGrain, [&](size_t begin, size_t end) {
    OneNeighbourhood one(work);
    for (size_t q = begin; q < end; ++q) {
      if (nearest[q] == kNoPoint) continue;
      const auto query = static_cast<uint32_t>(q);
      one.model(work.compared_cloud.point(work.compared.order()[q]), nearest[q], {&query, 1});
    }
  });
}

}  // namespace

uint64_t apply_local_models(const Octree& reference, const Octree& compared,
                            const Cloud& compared_cloud, std::span<const uint32_t> nearest,
                            const DistanceSettings& settings, const DistanceColumns& columns,
                            Task& task) {
  std::atomic<uint64_t> modelled{0};
  const Work work{reference, compared, compared_cloud, settings, settings.model_points(),
                  columns,   modelled};
  if (settings.neighbourhood == DistanceSettings::Neighbourhood::kPoint) {
    model_around_points(work, nearest, task);
    return modelled;
  }
  const NearestGroups groups(nearest, reference.size(), task);
  if (reference.size() / kSparse > compared.size()) model_used(work, groups, task);
  else model_all(work, groups, task);
  return modelled;
}

}  // namespace jalon
