// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Angles between the planes of a cell's points, against the angle they were made with and least squares in doubles.
#include "compare/preview/cell_planes.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/plane.h"
#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kCellBits = 0x1p-14;  // of the cell: what coordinates are taken to

/// A cloud with its tree in the unit cube.
struct Tree {
  Cloud cloud;
  std::shared_ptr<const Octree> tree;
  Tree(const std::vector<Vec3>& points, Task& task)
      : cloud(cloud_of(points)), tree(Octree::build(cloud.xyz(), {{}, 1}, task)) {}
};

double angle_in_cube(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  Task task;
  const Tree reference(a, task), compared(b, task);
  return plane_angle(*reference.tree, *compared.tree, 0, {0, 0, a.size(), 0, b.size()});
}

/// Points of a plane through the middle of the unit cube, 0.6 m wide.
std::vector<Vec3> slanted(const Vec3& normal, uint64_t stream, size_t n = 300) {
  RandomStream random(31, stream);
  const Vec3 u = normalized(cross(normal, {0.31, 0.9, 0.2})), v = cross(normal, u);
  std::vector<Vec3> out;
  for (size_t i = 0; i < n; ++i) {
    const double a = 0.6 * random.uniform() - 0.3, b = 0.6 * random.uniform() - 0.3;
    out.push_back(Vec3{0.5, 0.5, 0.5} + u * a + v * b);
  }
  return out;
}

}  // namespace

TEST_CASE("cell_planes__tell_the_angle_that_two_planes_were_made_with") {
  const Vec3 axis = normalized({0.2, 1, -0.4}), n = normalized(cross(axis, {1, 0, 0}));
  for (const double angle : {0.0, 0.001, 0.1, 0.7, 1.5, std::numbers::pi / 2, 1.8, 3.1}) {
    const Vec3 turned = n * std::cos(angle) + cross(axis, n) * std::sin(angle);
    const double folded = std::min(angle, std::numbers::pi - angle);  // planes have no front
    // 300 rounded coordinates over 0.6 of the cell: each normal is good to a tenth of their step.
    CHECK(std::fabs(angle_in_cube(slanted(n, 1), slanted(turned, 2)) - folded) < kCellBits);
    CHECK(std::fabs(angle_in_cube(slanted(-turned, 1), slanted(n, 2)) - folded) < kCellBits);
  }
}

TEST_CASE("cell_planes__of_small_cells_are_those_of_least_squares") {
  // Two wavy grounds, in cells of an eighth.
  const auto ground = [](uint64_t stream) {
    RandomStream random(32, stream);
    std::vector<Vec3> out;
    for (int i = 0; i < 8000; ++i) {
      const double x = random.uniform(), y = random.uniform();
      out.push_back({x, y, 0.45 + 0.04 * std::sin(9 * x + static_cast<double>(stream)) * y});
    }
    return out;
  };
  Task task;
  const Tree reference(ground(1), task), compared(ground(2), task);
  const auto fitted = [](const Tree& t, size_t first, size_t count, Plane& plane) {
    std::vector<Vec3> points;
    for (size_t i = first; i < first + count; ++i)
      points.push_back(t.cloud.point(t.tree->order()[i]));
    PlaneFit fit;
    // As wide as a tenth of the cell, so that the steps of coordinates turn it by 1e-3 at most.
    const bool wide = fit_plane(points, fit) && fit.eigenvalues[1] > 0.0125 * 0.0125;
    plane = fit.plane;
    return wide;
  };
  size_t checked = 0;
  for (const CellPair& pair : homologous_cells(*reference.tree, *compared.tree, 3, task)) {
    Plane a, b;
    if (!fitted(reference, pair.reference_first, pair.reference_count, a) ||
        !fitted(compared, pair.compared_first, pair.compared_count, b))
      continue;
    ++checked;
    const double truth = std::acos(std::min(1.0, std::fabs(dot(a.normal, b.normal))));
    CHECK(std::fabs(plane_angle(*reference.tree, *compared.tree, 3, pair) - truth) < 2e-3);
  }
  CHECK(checked > 40);
}

TEST_CASE("cell_planes__of_too_few_points_or_points_on_a_line_have_no_angle") {
  const auto plane = slanted({0, 0, 1}, 3);
  std::vector<Vec3> line;
  for (int i = 0; i < 30; ++i) line.push_back(Vec3{0.1, 0.2, 0.3} + Vec3{0.02, 0, 0} * i);
  for (const auto& poor :
       {line, {{0.1, 0.1, 0.1}, {0.7, 0.2, 0.4}}, std::vector<Vec3>(5, Vec3{0.3, 0.3, 0.3})}) {
    CHECK(std::isnan(angle_in_cube(plane, poor)));
    CHECK(std::isnan(angle_in_cube(poor, plane)));
  }
  CHECK(angle_in_cube(plane, {{0.1, 0.1, 0.1}, {0.7, 0.2, 0.1}, {0.3, 0.8, 0.1}}) < kCellBits);
}
