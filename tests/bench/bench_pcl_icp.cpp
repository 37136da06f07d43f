// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// bench_pcl_icp PREFIX: PCL's IterativeClosestPointWithNormals (point-to-plane) of PREFIX_moved.f64 on PREFIX.f64, with
// the normals of the reference, which are all it needs. Only the normals have threads.

#include <omp.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>
#include <pcl/search/kdtree.h>

#include "driver.h"

namespace {

using Cloud = pcl::PointCloud<pcl::PointNormal>;

Cloud::Ptr cloud_of(const std::vector<double>& xyz) {
  Cloud::Ptr cloud(new Cloud);
  cloud->resize(xyz.size() / 3);
  for (size_t i = 0; i < cloud->size(); ++i) {
    (*cloud)[i].x = static_cast<float>(xyz[3 * i]);
    (*cloud)[i].y = static_cast<float>(xyz[3 * i + 1]);
    (*cloud)[i].z = static_cast<float>(xyz[3 * i + 2]);
  }
  return cloud;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const Cloud::Ptr reference = cloud_of(bench::load_points(argv[1]));
  const Cloud::Ptr moving = cloud_of(bench::load_points(std::string(argv[1]) + "_moved"));
  const auto icp = [&](int threads, bool with_sample) {
    const bench::Stopwatch watch;
    const auto tree = std::make_shared<pcl::search::KdTree<pcl::PointNormal>>();
    pcl::NormalEstimationOMP<pcl::PointNormal, pcl::PointNormal> estimation(
        static_cast<unsigned>(threads));
    estimation.setInputCloud(reference);
    estimation.setSearchMethod(tree);
    estimation.setKSearch(bench::kNeighbours);
    estimation.compute(*reference);  // writes the normals, leaves the coordinates
    pcl::IterativeClosestPointWithNormals<pcl::PointNormal, pcl::PointNormal> registration;
    registration.setSearchMethodTarget(tree, true);
    registration.setInputTarget(reference);
    registration.setInputSource(moving);
    registration.setMaximumIterations(bench::kIterations);
    registration.setMaxCorrespondenceDistance(bench::kPairs_m);
    registration.setTransformationEpsilon(1e-10);
    registration.setEuclideanFitnessEpsilon(1e-9);
    Cloud laid;
    registration.align(laid);
    bench::Result result{watch.seconds(), static_cast<uint64_t>(registration.nr_iterations_), {}};
    if (with_sample)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j)
          result.sample.push_back(registration.getFinalTransformation()(i, j));
    return result;
  };
  return bench::serve("PCL", reference->size(), {{"icp", icp}});
}
