// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/normals_pca.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/random.h"
#include "geometry/symmetric_eigen.h"

using namespace jalon;

namespace {

std::shared_ptr<const Octree> build(const std::vector<double>& xyz, unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  Box3 box;
  for (size_t i = 0; i < xyz.size(); i += 3) box.add({xyz[i], xyz[i + 1], xyz[i + 2]});
  return Octree::build(xyz, enclosing_cube(box), task);
}

// A wavy sheet with noise and some strays, at national-grid size.
std::vector<double> sheet(size_t n, double noise, const Vec3& at) {
  RandomStream random(11, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < n; ++i) {
    const double x = 5 * random.uniform(), y = 5 * random.uniform();
    const double z =
        random.below(30) == 0 ? 3 * random.uniform() : 0.3 * std::sin(x) + noise * random.normal();
    xyz.insert(xyz.end(), {at.x + x, at.y + y, at.z + z});
  }
  return xyz;
}

// Covariance of the neighbours in doubles, by Jacobi rotations.
Eigen3 reference(const std::vector<double>& xyz, std::span<const Neighbour> neighbours) {
  Vec3 mean;
  const auto at = [&](size_t j) {
    const size_t i = neighbours[j].index, first = neighbours[0].index;
    return Vec3{xyz[3 * i] - xyz[3 * first], xyz[3 * i + 1] - xyz[3 * first + 1],
                xyz[3 * i + 2] - xyz[3 * first + 2]};
  };
  for (size_t j = 0; j < neighbours.size(); ++j)
    mean += at(j) / static_cast<double>(neighbours.size());
  Symmetric3 m{};
  for (size_t j = 0; j < neighbours.size(); ++j) {
    const Vec3 d = at(j) - mean;
    const double add[6] = {d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.y, d.y * d.z, d.z * d.z};
    for (size_t c = 0; c < 6; ++c) m[c] += add[c];
  }
  return symmetric_eigen(m);
}

void check_against_reference(const std::vector<double>& xyz, const PcaNormals& normals,
                             const Octree& tree, uint32_t k, double radius) {
  const auto normal = normals.normal->values<float>();
  const auto curvature = normals.curvature->values<float>();
  size_t compared = 0;
  double worst = 0, worst_variation = 0;
  for (size_t i = 0; i < tree.size(); i += 3) {
    const Vec3 p{xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
    std::vector<Neighbour> found(k);
    if (k != 0) tree.knn(p, k, found);
    else tree.radius(p, radius, found);
    if (found.size() < 3) {
      REQUIRE(std::isnan(normal[3 * i]));
      continue;
    }
    const Eigen3 e = reference(xyz, found);
    const double sum = e.values[0] + e.values[1] + e.values[2];
    const Vec3 n{normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]};
    REQUIRE(norm(n) == doctest::Approx(1).epsilon(1e-6));
    worst_variation = std::max(worst_variation, std::fabs(curvature[i] - e.values[0] / sum));
    if (e.values[1] - e.values[0] < 0.01 * sum) continue;  // the direction is not well defined
    worst = std::max(worst, norm(cross(n, e.vectors[0])));
    ++compared;
  }
  MESSAGE(compared << " normals: largest angle to the Jacobi solution " << worst
                   << " rad, of the variation " << worst_variation);
  REQUIRE(compared > tree.size() / 6);
  CHECK(worst < 1e-5);
  CHECK(worst_variation < 1e-6);
}

}  // namespace

TEST_CASE("pca_normals__equal_the_jacobi_solution") {
  for (const double noise : {0.0, 0.003, 0.05}) {
    const auto xyz = sheet(9000, noise, {652000, 6861000, 30});
    const auto tree = build(xyz);
    Task task;
    check_against_reference(xyz, pca_normals(*tree, 16, true, task), *tree, 16, 0);
    check_against_reference(xyz, pca_normals_radius(*tree, 0.2, true, task), *tree, 0, 0.2);
  }
}

// Balls of thousands of points are summed by parts of the tree.
TEST_CASE("pca_normals__by_a_radius_that_takes_in_much_of_the_cloud_equal_the_jacobi_solution") {
  const auto xyz = sheet(9000, 0.05, {652000, 6861000, 30});
  const auto tree = build(xyz);
  for (const double radius : {1.2, 2.5}) {
    Task task;
    check_against_reference(xyz, pca_normals_radius(*tree, radius, true, task), *tree, 0, radius);
  }
}

// Thousands of points on one place: they are taken together, as they are one by one.
TEST_CASE("pca_normals__by_radius_of_a_pile_equal_the_jacobi_solution") {
  std::vector<double> xyz = sheet(16000, 0.01, {0, 0, 0});
  for (size_t i = 0; i < 16000; i += 2)
    for (size_t c = 0; c < 3; ++c) xyz[3 * i + c] = xyz[c];
  const auto tree = build(xyz);
  REQUIRE(tree->has_crowds());
  Task task;
  const PcaNormals normals = pca_normals_radius(*tree, 0.5, true, task);
  std::vector<Neighbour> near;
  size_t crowded = 0;
  for (size_t i = 1; i < 16000; i += 331) {
    tree->radius({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}, 0.5, near);
    const Eigen3 truth = reference(xyz, near);
    const float* n = normals.normal->values<float>().data() + 3 * i;
    if (near.size() < 20 || truth.values[1] < 1.5 * truth.values[0]) continue;
    crowded += near.size() > 8000;
    const Vec3 found{n[0], n[1], n[2]};
    CHECK(std::fabs(dot(found, truth.vectors[0])) > 1 - 1e-6);
  }
  CHECK(crowded > 0);
}

TEST_CASE("pca_normals__are_the_same_for_any_number_of_threads_and_after_a_shift") {
  auto xyz = sheet(9000, 0.003, {0, 0, 0});
  for (double& v : xyz) v = std::round(v * 0x1p20) * 0x1p-20;
  auto shifted = xyz;
  for (size_t i = 0; i < xyz.size(); ++i)
    shifted[i] += i % 3 == 0 ? 652000.0 : i % 3 == 1 ? 6861000.0 : 35.0;
  Task::Hooks hooks;
  hooks.threads = 1;
  Task one(hooks);
  hooks.threads = 7;
  Task seven(hooks);
  const auto a = pca_normals(*build(xyz), 16, true, one),
             b = pca_normals(*build(shifted, 7), 16, true, seven);
  CHECK(std::memcmp(a.normal->raw(), b.normal->raw(), a.normal->bytes()) == 0);
  CHECK(std::memcmp(a.curvature->raw(), b.curvature->raw(), a.curvature->bytes()) == 0);
  const auto c = pca_normals_radius(*build(xyz), 2, false, one),
             d = pca_normals_radius(*build(shifted, 7), 2, false, seven);
  CHECK(std::memcmp(c.normal->raw(), d.normal->raw(), c.normal->bytes()) == 0);
}

TEST_CASE("pca_normals__are_nan_where_the_points_span_no_plane") {
  Task task;
  std::vector<double> line, equal;
  for (int i = 0; i < 300; ++i) {
    line.insert(line.end(), {652000 + 0.1 * i, 6861000.0, 5.0});
    equal.insert(equal.end(), {1, 2, 3});
  }
  for (const auto& xyz :
       {line, equal, std::vector<double>{0, 0, 0, 1, 1, 1}, std::vector<double>{4, 5, 6}}) {
    const auto tree = build(xyz);
    for (const auto& normals :
         {pca_normals(*tree, 8, false, task), pca_normals_radius(*tree, 1, false, task)})
      for (const float v : normals.normal->values<float>()) REQUIRE(std::isnan(v));
  }
  const auto plane = build({0, 0, 0, 1, 0, 0, 0, 1, 0});
  CHECK(std::fabs(pca_normals(*plane, 8, false, task).normal->values<float>()[2]) ==
        doctest::Approx(1));
}
