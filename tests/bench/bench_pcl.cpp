// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// bench_pcl PREFIX: PCL's FLANN kd-tree, NormalEstimationOMP, VoxelGrid and RegionGrowing. Its tree,
// its voxel grid and its growing are serial.

#include <Eigen/Eigenvalues>
#include <omp.h>
#include <pcl/common/centroid.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>

#include <cmath>
#include <memory>

#include "driver.h"

namespace {

// PCL's regions have no planes: least squares through the points of each, outside the time that is taken.
std::vector<double> rows_of_planes(const pcl::PointCloud<pcl::PointXYZ>& cloud,
                                   const std::vector<pcl::PointIndices>& regions) {
  std::vector<double> rows;
  for (const pcl::PointIndices& region : regions) {
    Eigen::Matrix3d covariance;
    Eigen::Vector4d centroid;
    pcl::computeMeanAndCovarianceMatrix(cloud, region.indices, covariance, centroid);
    const Eigen::Vector3d normal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
    for (int axis = 0; axis < 3; ++axis) rows.push_back(normal[axis]);
    for (int axis = 0; axis < 3; ++axis) rows.push_back(centroid[axis]);
    rows.push_back(static_cast<double>(region.indices.size()));
  }
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  const Cloud::Ptr cloud(new Cloud);
  {
    const std::vector<double> xyz = bench::load_points(argv[1]);
    cloud->reserve(xyz.size() / 3);
    for (size_t i = 0; i < xyz.size(); i += 3) {
      cloud->emplace_back(static_cast<float>(xyz[i]), static_cast<float>(xyz[i + 1]),
                          static_cast<float>(xyz[i + 2]));
    }
  }
  const size_t n = cloud->size();
  using Tree = pcl::KdTreeFLANN<pcl::PointXYZ>;
  std::unique_ptr<Tree> tree;
  const auto build = [&](int, bool) {
    tree.reset();
    const bench::Stopwatch watch;
    tree = std::make_unique<Tree>();
    tree->setInputCloud(cloud);
    return bench::Result{watch.seconds(), n, {}};
  };
  std::vector<int> indices;
  std::vector<float> distances;
  const auto knn = [&](int threads, bool with_sample) {
    if (!tree) build(threads, false);
    indices.resize(n * bench::kNeighbours);
    distances.resize(n * bench::kNeighbours);
    const bench::Stopwatch watch;
#pragma omp parallel num_threads(threads)
    {
      std::vector<int> found(bench::kNeighbours);
      std::vector<float> squared(bench::kNeighbours);
#pragma omp for schedule(dynamic, 4096)
      for (size_t i = 0; i < n; ++i) {
        tree->nearestKSearch((*cloud)[i], bench::kNeighbours, found, squared);
        std::memcpy(&indices[i * bench::kNeighbours], found.data(),
                    bench::kNeighbours * sizeof(int));
        std::memcpy(&distances[i * bench::kNeighbours], squared.data(),
                    bench::kNeighbours * sizeof(float));
      }
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
  Cloud second;
  std::vector<double> nearest;
  const auto c2c = [&](int threads, bool with_sample) {
    if (second.empty()) {
      const std::vector<double> xyz = bench::load_second_scan(argv[1]);
      for (size_t i = 0; i < xyz.size(); i += 3)
        second.emplace_back(static_cast<float>(xyz[i]), static_cast<float>(xyz[i + 1]),
                            static_cast<float>(xyz[i + 2]));
      nearest.assign(second.size(), 0.0);
    }
    const bench::Stopwatch watch;
    Tree fresh;
    fresh.setInputCloud(cloud);
#pragma omp parallel num_threads(threads)
    {
      std::vector<int> found(1);
      std::vector<float> squared(1);
#pragma omp for schedule(dynamic, 4096)
      for (size_t i = 0; i < nearest.size(); ++i) {
        fresh.nearestKSearch(second[i], 1, found, squared);
        nearest[i] = std::sqrt(static_cast<double>(squared[0]));
      }
    }
    return bench::distances(watch, nearest, with_sample);
  };
  using SearchTree = pcl::search::KdTree<pcl::PointXYZ>;
  const auto estimate = [&](int threads, const SearchTree::Ptr& search,
                            pcl::PointCloud<pcl::Normal>& field) {
    pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(static_cast<unsigned>(threads));
    estimation.setInputCloud(cloud);
    estimation.setSearchMethod(search);
    estimation.setKSearch(bench::kNeighbours);
    estimation.compute(field);
  };
  const auto normals = [&](int threads, bool with_sample) {
    pcl::PointCloud<pcl::Normal> field;
    const bench::Stopwatch watch;
    estimate(threads, std::make_shared<SearchTree>(), field);
    bench::Result result{watch.seconds(), n, {}};
    if (with_sample) {
      bench::for_samples(n, [&](size_t i) {
        for (int axis = 0; axis < 3; ++axis) result.sample.push_back(field[i].normal[axis]);
      });
    }
    return result;
  };
  const auto voxel = [&](int, bool) {
    Cloud thinned;
    const bench::Stopwatch watch;
    pcl::VoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    const auto leaf_m = static_cast<float>(bench::kVoxel_m);
    grid.setLeafSize(leaf_m, leaf_m, leaf_m);
    grid.filter(thinned);
    return bench::Result{watch.seconds(), thinned.size(), {}};
  };
  const auto grow = [&](int threads, bool with_sample) {
    const bench::Stopwatch watch;
    const auto search = std::make_shared<SearchTree>();  // built by the normals, used again
    const auto field = std::make_shared<pcl::PointCloud<pcl::Normal>>();
    estimate(threads, search, *field);
    pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
    growing.setMinClusterSize(200);
    growing.setMaxClusterSize(static_cast<int>(n));
    growing.setSearchMethod(search);
    growing.setNumberOfNeighbours(bench::kNeighbours);
    growing.setInputCloud(cloud);
    growing.setInputNormals(field);
    growing.setSmoothnessThreshold(static_cast<float>(5 * M_PI / 180));
    growing.setCurvatureThreshold(0.02f);
    std::vector<pcl::PointIndices> regions;
    growing.extract(regions);
    bench::Result result{watch.seconds(), regions.size(), {}};
    if (with_sample) result.sample = rows_of_planes(*cloud, regions);
    return result;
  };
  return bench::serve("PCL", n,
                      {{"index", build},
                       {"knn16", knn},
                       {"normals16", normals},
                       {"voxel5cm", voxel},
                       {"c2c", c2c},
                       {"region_growing", grow}});
}
