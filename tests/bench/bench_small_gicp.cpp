// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// bench_small_gicp PREFIX: small_gicp's C++ headers, each operation in its form for OpenMP when it
// runs on more than one thread.

#include <cmath>
#include <memory>
#include <small_gicp/ann/kdtree_omp.hpp>
#include <small_gicp/points/point_cloud.hpp>
#include <small_gicp/util/downsampling.hpp>
#include <small_gicp/util/downsampling_omp.hpp>
#include <small_gicp/util/normal_estimation_omp.hpp>

#include "driver.h"

namespace {

using Cloud = small_gicp::PointCloud;
using Tree = small_gicp::UnsafeKdTree<Cloud>;

std::unique_ptr<Tree> built(const Cloud& cloud, int threads) {
  if (threads == 1) return std::make_unique<Tree>(cloud);
  return std::make_unique<Tree>(cloud, small_gicp::KdTreeBuilderOMP(threads));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  Cloud cloud;
  {
    const std::vector<double> xyz = bench::load_points(argv[1]);
    cloud.resize(xyz.size() / 3);
    for (size_t i = 0; i < cloud.size(); ++i)
      cloud.point(i) << xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2], 1.0;
  }
  const size_t n = cloud.size();
  std::unique_ptr<Tree> tree;
  const auto build = [&](int threads, bool) {
    tree.reset();
    const bench::Stopwatch watch;
    tree = built(cloud, threads);
    return bench::Result{watch.seconds(), n, {}};
  };
  std::vector<size_t> indices;
  std::vector<double> distances;
  const auto knn = [&](int threads, bool with_sample) {
    if (!tree) build(threads, false);
    indices.resize(n * bench::kNeighbours);
    distances.resize(n * bench::kNeighbours);
    const bench::Stopwatch watch;
#pragma omp parallel for schedule(dynamic, 4096) num_threads(threads)
    for (size_t i = 0; i < n; ++i) {
      const size_t at = i * bench::kNeighbours;
      tree->knn_search<bench::kNeighbours>(cloud.point(i), &indices[at], &distances[at]);
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
  const auto normals = [&](int threads, bool with_sample) {
    const bench::Stopwatch watch;
    const auto fresh = built(cloud, threads);
    small_gicp::estimate_normals_omp(cloud, *fresh, bench::kNeighbours, threads);
    bench::Result result{watch.seconds(), n, {}};
    if (with_sample) {
      bench::for_samples(n, [&](size_t i) {
        for (int axis = 0; axis < 3; ++axis) result.sample.push_back(cloud.normal(i)[axis]);
      });
    }
    return result;
  };
  const auto voxel = [&](int threads, bool) {
    const bench::Stopwatch watch;
    const auto thinned = threads == 1
                             ? small_gicp::voxelgrid_sampling(cloud, bench::kVoxel_m)
                             : small_gicp::voxelgrid_sampling_omp(cloud, bench::kVoxel_m, threads);
    return bench::Result{watch.seconds(), thinned->size(), {}};
  };
  std::vector<Eigen::Vector4d> second;
  std::vector<double> nearest;
  const auto c2c = [&](int threads, bool with_sample) {
    if (second.empty()) {
      const std::vector<double> xyz = bench::load_second_scan(argv[1]);
      for (size_t i = 0; i < xyz.size(); i += 3)
        second.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2], 1.0);
      nearest.assign(second.size(), 0.0);
    }
    const bench::Stopwatch watch;
    const auto fresh = built(cloud, threads);
#pragma omp parallel for schedule(dynamic, 4096) num_threads(threads)
    for (size_t i = 0; i < nearest.size(); ++i) {
      size_t index = 0;
      double squared = 0;
      fresh->nearest_neighbor_search(second[i], &index, &squared);
      nearest[i] = std::sqrt(squared);
    }
    return bench::distances(watch, nearest, with_sample);
  };
  return bench::serve("small_gicp", n,
                      {{"index", build},
                       {"knn16", knn},
                       {"normals16", normals},
                       {"voxel5cm", voxel},
                       {"c2c", c2c}});
}
