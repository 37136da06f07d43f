// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "fieldtools/chi_square.h"
#include "fieldtools/field_values.h"
#include "fieldtools/gradient.h"
#include "fieldtools/propagation.h"
#include "fieldtools/smoothing.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

/// The surfaces of a hall with n points, deviations of a noise law and 100 balls of 0.3 m radius that have moved.
struct Hall {
  Cloud cloud;
  NoiseLaw law;
};
Hall hall(size_t n) {
  Hall out;
  out.law.kind = LawKind::kWeibull;
  out.law.shape = 1.5;
  out.law.scale = 0.003;
  RandomStream random(1, n);
  std::vector<Vec3> balls(100);
  const double size[3] = {20, 12, 6};
  const auto on_wall = [&] {
    Vec3 p{size[0] * random.uniform(), size[1] * random.uniform(), size[2] * random.uniform()};
    const auto axis = static_cast<int>(random.below(3));
    p[axis] = random.below(2) != 0 ? size[axis] : 0;
    return p;
  };
  for (size_t i = 0; i < balls.size(); ++i)  // apart from each other
    for (bool free = false; !free;) {
      balls[i] = on_wall();
      free = std::all_of(balls.begin(), balls.begin() + static_cast<ptrdiff_t>(i),
                         [&](const Vec3& b) { return norm(b - balls[i]) > 1; });
    }
  std::vector<Vec3> points(n);
  std::vector<double> values(n);
  for (size_t i = 0; i < n; ++i) {
    points[i] = on_wall();
    values[i] = out.law.quantile(random.uniform());
    for (const Vec3& b : balls) {
      const double d = norm(points[i] - b);
      if (d < 0.3) values[i] += 0.3 - d;
    }
  }
  out.cloud = with_field<double>(cloud_of(points), "distance", "m", "", values);
  return out;
}

/// Of the processor, of all threads together: what else the machine does is not counted.
double seconds_of(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

struct Row {
  size_t points;
  double statistical_s, propagation_s;  ///< totals of tables 3.1 and 3.2
};
constexpr Row kRows[] = {{34931, 1.34, 2.42}, {932136, 46.46, 171.03}, {2180182, 108.9, 390.69}};

TEST_CASE("field_tools__tables_3_1_and_3_2__thirty_times_faster") {
  const bool small = std::getenv("JALON_SANITIZED") != nullptr;
  for (const Row& row : kRows) {
    if (small && row.points > 50000) continue;
    const Hall h = hall(row.points);
    Task task;
    // 1. Octree, local chi-square in two passes, components.
    std::clock_t start = std::clock();
    const ChangeFilter found = filter_changes(h.cloud, scalar_values(h.cloud, "distance", task),
                                              h.law, ChiSquareSettings{}, task);
    const double filter_s = seconds_of(start);
    const Cloud marked = with_field<uint8_t>(h.cloud, "changed", "", "", found.changed);
    ComponentsSettings grid;
    grid.field = "changed";
    uint64_t components = 0;
    with_components(marked, grid, task, components);
    const double statistical_s = seconds_of(start);
    // 2. Octree, gradient, blur, propagation.
    Cloud again = h.cloud;
    again.index = std::make_shared<IndexSlot>();  // the octree counts once more
    start = std::clock();
    const Cloud steep = with_gradient(again, "distance", GradientSettings{}, task);
    const double gradient_s = seconds_of(start);
    const Cloud smooth = with_filtered_field(steep, "gradient", FieldFilterSettings{}, task);
    const double blur_s = seconds_of(start) - gradient_s;
    const PropagationResult regions = segment_by_propagation(
        smooth, scalar_values(smooth, "distance", task), scalar_values(smooth, "filtered", task),
        PropagationSettings{}, task);
    const double propagation_s = seconds_of(start);
    MESSAGE("FIGURE T6, ", row.points, " points: ", statistical_s, " CPU s (filter ", filter_s,
            "), ", row.statistical_s / statistical_s, " x faster than printed; ", components,
            " components");
    MESSAGE("FIGURE T7, ", row.points, " points: ", propagation_s, " CPU s (octree and gradient ",
            gradient_s, ", blur ", blur_s, "), ", row.propagation_s / propagation_s,
            " x faster than printed; ", regions.regions.at(0)->count(), " regions");
    if (small) continue;
    CHECK(row.statistical_s / statistical_s > 30);
    CHECK(row.propagation_s / propagation_s > 30);
  }
}

}  // namespace
}  // namespace jalon
