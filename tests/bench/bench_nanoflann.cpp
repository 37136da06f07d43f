// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// bench_nanoflann PREFIX [f64]: nanoflann's kd-tree over floats (its fastest form) or doubles. It
// has no normals and no voxel grid.

#include <omp.h>

#include <cmath>
#include <memory>
#include <nanoflann.hpp>

#include "driver.h"

namespace {

template <class T>
struct Points {
  std::vector<T> xyz;
  size_t kdtree_get_point_count() const { return xyz.size() / 3; }
  T kdtree_get_pt(size_t i, size_t axis) const { return xyz[3 * i + axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

template <class T>
int run(const char* peer, const char* prefix) {
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<T, Points<T>>,
                                                   Points<T>, 3, uint32_t>;
  constexpr size_t kLeafSize = 10;  // nanoflann's default
  Points<T> points;
  {
    const std::vector<double> xyz = bench::load_points(prefix);
    points.xyz.assign(xyz.begin(), xyz.end());
  }
  const size_t n = points.kdtree_get_point_count();
  std::unique_ptr<Tree> tree;
  const auto build = [&](int, bool) {
    tree.reset();
    const bench::Stopwatch watch;
    tree = std::make_unique<Tree>(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize));
    tree->buildIndex();
    return bench::Result{watch.seconds(), n, {}};
  };
  std::vector<uint32_t> indices;
  std::vector<T> distances;
  const auto knn = [&](int threads, bool with_sample) {
    if (!tree) build(threads, false);
    indices.resize(n * bench::kNeighbours);
    distances.resize(n * bench::kNeighbours);
    const bench::Stopwatch watch;
#pragma omp parallel for schedule(dynamic, 4096) num_threads(threads)
    for (size_t i = 0; i < n; ++i) {
      const size_t at = i * bench::kNeighbours;
      tree->knnSearch(&points.xyz[3 * i], bench::kNeighbours, &indices[at], &distances[at]);
    }
    bench::Result result{watch.seconds(), n, {}};
    if (with_sample) {
      bench::for_samples(n, [&](size_t i) {
        for (size_t k = 0; k < bench::kNeighbours; ++k)
          result.sample.push_back(distances[i * bench::kNeighbours + k]);
      });
    }
    return result;
  };
  std::vector<T> second;
  std::vector<double> nearest;
  const auto c2c = [&](int threads, bool with_sample) {
    if (second.empty()) {
      const std::vector<double> xyz = bench::load_second_scan(prefix);
      second.assign(xyz.begin(), xyz.end());
      nearest.assign(second.size() / 3, 0.0);
    }
    const bench::Stopwatch watch;
    const auto fresh =
        std::make_unique<Tree>(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize));
    fresh->buildIndex();
#pragma omp parallel for schedule(dynamic, 4096) num_threads(threads)
    for (size_t i = 0; i < nearest.size(); ++i) {
      uint32_t index = 0;
      T squared = 0;
      fresh->knnSearch(&second[3 * i], 1, &index, &squared);
      nearest[i] = std::sqrt(static_cast<double>(squared));
    }
    return bench::distances(watch, nearest, with_sample);
  };
  return bench::serve(peer, n, {{"index", build}, {"knn16", knn}, {"c2c", c2c}});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  return argc > 2 && std::strcmp(argv[2], "f64") == 0 ? run<double>("nanoflann-f64", argv[1])
                                                      : run<float>("nanoflann", argv[1]);
}
