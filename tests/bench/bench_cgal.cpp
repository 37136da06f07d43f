// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// bench_cgal PREFIX: CGAL's kd-tree, pca_estimate_normals, grid_simplify_point_set (which keeps one
// point a cell and is serial) and Efficient_RANSAC for planes (serial; its normals are not).

#define CGAL_LINKED_WITH_TBB
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/grid_simplify_point_set.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <memory>
#include <utility>

#include "driver.h"

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Oriented = std::pair<Point, Kernel::Vector_3>;
using Numbered = std::pair<Point, uint32_t>;
using Traits = CGAL::Search_traits_adapter<Numbered, CGAL::First_of_pair_property_map<Numbered>,
                                           CGAL::Search_traits_3<Kernel>>;
using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
using PointMap = CGAL::First_of_pair_property_map<Oriented>;
using NormalMap = CGAL::Second_of_pair_property_map<Oriented>;
using RansacTraits = CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, std::vector<Oriented>,
                                                                    PointMap, NormalMap>;
using Ransac = CGAL::Shape_detection::Efficient_RANSAC<RansacTraits>;
using Plane = CGAL::Shape_detection::Plane<RansacTraits>;

template <class Tag>
void estimate(std::vector<Oriented>& points) {
  // CGAL counts the neighbours besides the point itself; the others count the point as well.
  CGAL::pca_estimate_normals<Tag>(points, bench::kNeighbours - 1,
                                  CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));
}

void estimate(std::vector<Oriented>& points, int threads) {
  if (threads > 1) {
    estimate<CGAL::Parallel_tag>(points);
  } else {
    estimate<CGAL::Sequential_tag>(points);
  }
}

std::vector<Oriented> without_normals(const std::vector<Point>& points) {
  std::vector<Oriented> oriented;
  for (const Point& p : points) oriented.emplace_back(p, Kernel::Vector_3());
  return oriented;
}

Ransac::Parameters ransac_parameters(size_t points) {
  Ransac::Parameters parameters;
  parameters.probability = 0.01;  // of missing the largest plane
  parameters.min_points = points / 500;
  parameters.epsilon = 0.015;
  parameters.cluster_epsilon = 0.15;
  parameters.normal_threshold = 0.9;
  return parameters;
}

std::vector<double> rows_of_planes(const Ransac& ransac, const std::vector<Point>& points) {
  std::vector<double> rows;
  for (const auto& shape : ransac.shapes()) {
    const auto* plane = dynamic_cast<const Plane*>(shape.get());
    const auto& members = shape->indices_of_assigned_points();
    if (plane == nullptr || members.empty()) continue;
    double sum[3] = {0, 0, 0};
    for (const size_t i : members)
      for (int axis = 0; axis < 3; ++axis) sum[axis] += points[i][axis];
    const auto count = static_cast<double>(members.size());
    // CGAL does not refit: the foot of the centroid on its plane.
    double off = plane->d();
    for (int axis = 0; axis < 3; ++axis) off += plane->plane_normal()[axis] * sum[axis] / count;
    for (int axis = 0; axis < 3; ++axis) rows.push_back(plane->plane_normal()[axis]);
    for (int axis = 0; axis < 3; ++axis)
      rows.push_back(sum[axis] / count - off * plane->plane_normal()[axis]);
    rows.push_back(count);
  }
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  std::vector<Point> points;
  {
    const std::vector<double> xyz = bench::load_points(argv[1]);
    for (size_t i = 0; i < xyz.size(); i += 3) points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
  }
  const size_t n = points.size();
  std::vector<Numbered> numbered;
  for (size_t i = 0; i < n; ++i) numbered.emplace_back(points[i], static_cast<uint32_t>(i));
  std::unique_ptr<Search::Tree> tree;
  const auto build = [&](int threads, bool) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<size_t>(threads));
    tree.reset();
    const bench::Stopwatch watch;
    tree = std::make_unique<Search::Tree>(numbered.begin(), numbered.end());
    if (threads > 1) {
      tree->build<CGAL::Parallel_tag>();
    } else {
      tree->build();
    }
    return bench::Result{watch.seconds(), n, {}};
  };
  std::vector<uint32_t> indices;
  std::vector<double> distances;
  const auto knn = [&](int threads, bool with_sample) {
    if (!tree) build(threads, false);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<size_t>(threads));
    indices.resize(n * bench::kNeighbours);
    distances.resize(n * bench::kNeighbours);
    const bench::Stopwatch watch;
    tbb::parallel_for(tbb::blocked_range<size_t>(0, n, 4096),
                      [&](const tbb::blocked_range<size_t>& range) {
                        for (size_t i = range.begin(); i < range.end(); ++i) {
                          size_t at = i * bench::kNeighbours;
                          const Search search(*tree, points[i], bench::kNeighbours);
                          for (const auto& [neighbour, squared] : search) {
                            indices[at] = neighbour.second;
                            distances[at++] = squared;
                          }
                        }
                      });
    bench::Result result{watch.seconds(), n, {}};
    if (with_sample) {
      bench::for_samples(n, [&](size_t i) {
        for (size_t k = 0; k < bench::kNeighbours; ++k)
          result.sample.push_back(distances[i * bench::kNeighbours + k]);
      });
    }
    return result;
  };
  std::vector<Point> second;
  std::vector<double> nearest;
  const auto c2c = [&](int threads, bool with_sample) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<size_t>(threads));
    if (second.empty()) {
      const std::vector<double> xyz = bench::load_second_scan(argv[1]);
      for (size_t i = 0; i < xyz.size(); i += 3)
        second.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
      nearest.assign(second.size(), 0.0);
    }
    using Plain = CGAL::Orthogonal_k_neighbor_search<
        CGAL::Search_traits_3<Kernel>>;  // distances need no numbers
    const bench::Stopwatch watch;
    Plain::Tree fresh(points.begin(), points.end());
    if (threads > 1) {
      fresh.build<CGAL::Parallel_tag>();
    } else {
      fresh.build();
    }
    tbb::parallel_for(tbb::blocked_range<size_t>(0, second.size(), 4096),
                      [&](const tbb::blocked_range<size_t>& range) {
                        for (size_t i = range.begin(); i < range.end(); ++i) {
                          const Plain search(fresh, second[i], 1);
                          nearest[i] = std::sqrt(search.begin()->second);
                        }
                      });
    return bench::distances(watch, nearest, with_sample);
  };
  const auto normals = [&](int threads, bool with_sample) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<size_t>(threads));
    std::vector<Oriented> oriented = without_normals(points);
    const bench::Stopwatch watch;
    estimate(oriented, threads);
    bench::Result result{watch.seconds(), n, {}};
    if (with_sample) {
      bench::for_samples(n, [&](size_t i) {
        for (int axis = 0; axis < 3; ++axis) result.sample.push_back(oriented[i].second[axis]);
      });
    }
    return result;
  };
  const auto voxel = [&](int, bool) {
    std::vector<Point> copy = points;
    const bench::Stopwatch watch;
    copy.erase(CGAL::grid_simplify_point_set(copy, bench::kVoxel_m), copy.end());
    return bench::Result{watch.seconds(), copy.size(), {}};
  };
  const auto planes = [&](int threads, bool with_sample) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<size_t>(threads));
    std::vector<Oriented> oriented = without_normals(points);
    const bench::Stopwatch watch;
    estimate(oriented, threads);
    Ransac ransac;
    ransac.set_input(oriented);
    ransac.add_shape_factory<Plane>();
    ransac.detect(ransac_parameters(n));
    bench::Result result{watch.seconds(), ransac.shapes().size(), {}};
    if (with_sample) result.sample = rows_of_planes(ransac, points);
    return result;
  };
  return bench::serve("CGAL", n,
                      {{"index", build},
                       {"knn16", knn},
                       {"normals16", normals},
                       {"voxel5cm", voxel},
                       {"c2c", c2c},
                       {"planes", planes}});
}
