// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// bench_small_gicp_icp PREFIX [gicp|cauchy]: small_gicp's registration of PREFIX_moved.f64 on
// PREFIX.f64, point-to-plane
// or GICP with its own limits of convergence, or point-to-plane with a Cauchy kernel until the steps are small. Trees,
// normals and covariances are part of the time.

#include <omp.h>

#include <cmath>
#include <memory>
#include <small_gicp/ann/kdtree_omp.hpp>
#include <small_gicp/factors/gicp_factor.hpp>
#include <small_gicp/factors/plane_icp_factor.hpp>
#include <small_gicp/factors/robust_kernel.hpp>
#include <small_gicp/points/point_cloud.hpp>
#include <small_gicp/registration/reduction_omp.hpp>
#include <small_gicp/registration/registration.hpp>
#include <small_gicp/util/normal_estimation_omp.hpp>

#include "driver.h"

namespace {

using Cloud = small_gicp::PointCloud;
using Tree = small_gicp::UnsafeKdTree<Cloud>;
using PlaneFactor = small_gicp::PointToPlaneICPFactor;
using CauchyFactor = small_gicp::RobustFactor<small_gicp::Cauchy, PlaneFactor>;

Cloud cloud_of(const std::vector<double>& xyz) {
  Cloud cloud;
  cloud.resize(xyz.size() / 3);
  for (size_t i = 0; i < cloud.size(); ++i)
    cloud.point(i) << xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2], 1.0;
  return cloud;
}

std::unique_ptr<Tree> built(const Cloud& cloud, int threads) {
  if (threads == 1) return std::make_unique<Tree>(cloud);
  return std::make_unique<Tree>(cloud, small_gicp::KdTreeBuilderOMP(threads));
}

template <class Factor>
small_gicp::RegistrationResult aligned(const Cloud& reference, const Cloud& moving,
                                       const Tree& tree, int threads, bool exact) {
  small_gicp::Registration<Factor, small_gicp::ParallelReductionOMP> registration;
  registration.reduction.num_threads = threads;
  registration.rejector.max_dist_sq = bench::kPairs_m * bench::kPairs_m;
  if constexpr (std::is_same_v<Factor, CauchyFactor>)
    registration.point_factor.robust_kernel.c = bench::kKernel_m;
  if (exact) {
    registration.optimizer.max_iterations = bench::kIterations;
    registration.criteria.translation_eps = 1e-5;
    registration.criteria.rotation_eps = 1e-6;
  }
  return registration.align(reference, moving, tree);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::string kind = argc > 2 ? argv[2] : "";
  const std::string peer = kind.empty() ? "small_gicp" : "small_gicp-" + kind;
  Cloud reference = cloud_of(bench::load_points(argv[1]));
  Cloud moving = cloud_of(bench::load_points(std::string(argv[1]) + "_moved"));
  const auto icp = [&](int threads, bool with_sample) {
    const bench::Stopwatch watch;
    const auto tree = built(reference, threads);
    small_gicp::RegistrationResult found;
    if (kind == "gicp") {
      small_gicp::estimate_covariances_omp(reference, *tree, bench::kNeighbours, threads);
      const auto moving_tree = built(moving, threads);
      small_gicp::estimate_covariances_omp(moving, *moving_tree, bench::kNeighbours, threads);
      found = aligned<small_gicp::GICPFactor>(reference, moving, *tree, threads, false);
    } else {
      small_gicp::estimate_normals_omp(reference, *tree, bench::kNeighbours, threads);
      found = kind == "cauchy" ? aligned<CauchyFactor>(reference, moving, *tree, threads, true)
                               : aligned<PlaneFactor>(reference, moving, *tree, threads, false);
    }
    bench::Result result{watch.seconds(), found.iterations, {}};
    if (with_sample)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j) result.sample.push_back(found.T_target_source.matrix()(i, j));
    return result;
  };
  return bench::serve(peer, reference.size(), {{"icp", icp}});
}
