// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// bench_cgal_mesh PREFIX: CGAL's AABB tree with the tree of hints for distances, unsigned; the
// building of both is serial.

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "driver.h"

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Triangles = std::vector<Triangle>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

/// CGAL wants no triangles without area.
Triangles load_triangles(const std::string& prefix) {
  const std::vector<double> v = bench::load_points(prefix);
  Triangles triangles;
  for (size_t i = 0; i + 8 < v.size(); i += 9) {
    const Triangle t({v[i], v[i + 1], v[i + 2]}, {v[i + 3], v[i + 4], v[i + 5]},
                     {v[i + 6], v[i + 7], v[i + 8]});
    if (!t.is_degenerate()) triangles.push_back(t);
  }
  return triangles;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::string prefix = argv[1];
  const std::vector<double> xyz = bench::load_points(prefix);
  const Triangles coarse = load_triangles(prefix + "_mesh13k"),
                  fine = load_triangles(prefix + "_mesh1m");
  std::vector<double> nearest(xyz.size() / 3, 0.0);
  const auto measure = [&](const Triangles& triangles, int threads, bool with_sample) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<size_t>(threads));
    const bench::Stopwatch watch;
    Tree tree(triangles.begin(), triangles.end());
    tree.build();
    tree.accelerate_distance_queries();
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, nearest.size(), 1024),
        [&](const tbb::blocked_range<size_t>& range) {
          for (size_t i = range.begin(); i < range.end(); ++i)
            nearest[i] =
                std::sqrt(tree.squared_distance(Point(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2])));
        });
    return bench::distances(watch, nearest, with_sample);
  };
  return bench::serve(
      "CGAL", nearest.size(),
      {{"c2m_13k", [&](int threads, bool sample) { return measure(coarse, threads, sample); }},
       {"c2m_1m", [&](int threads, bool sample) { return measure(fine, threads, sample); }}});
}
