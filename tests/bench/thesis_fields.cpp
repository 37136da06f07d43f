// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What is done with a field of distances, at the sizes of Girardeau-Montaut 2006: tables 3.1 (T6) and 3.2 (T7).
#include <algorithm>

#include "bench/thesis.h"
#include "fieldtools/chi_square.h"
#include "fieldtools/field_values.h"
#include "fieldtools/gradient.h"
#include "fieldtools/propagation.h"
#include "fieldtools/smoothing.h"
#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::bench;
using namespace jalon::test;

namespace {

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

struct Row {
  size_t points;
  double statistical_s, propagation_s;  ///< totals of tables 3.1 and 3.2
};
constexpr Row kRows[] = {{34931, 1.34, 2.42}, {932136, 46.46, 171.03}, {2180182, 108.9, 390.69}};

/// Octree, local chi-square in two passes, components.
void statistical(const Hall& hall, const Row& row, Table& table) {
  Task task;
  uint64_t components = 0;
  const double seconds = processor_seconds([&] {
    const ChangeFilter found =
        filter_changes(hall.cloud, scalar_values(hall.cloud, "distance", task), hall.law,
                       ChiSquareSettings{}, task);
    const Cloud marked = with_field<uint8_t>(hall.cloud, "changed", "", "", found.changed);
    ComponentsSettings grid;
    grid.field = "changed";
    with_components(marked, grid, task, components);
  });
  table.add(std::to_string(row.points) + " points, " + std::to_string(components) + " components",
            seconds, row.statistical_s);
}

/// Octree, gradient, blur, propagation.
void propagated(const Hall& hall, const Row& row, Table& table) {
  Task task;
  Cloud again = hall.cloud;
  again.index = std::make_shared<IndexSlot>();  // the octree counts once more
  uint64_t regions = 0;
  const double seconds = processor_seconds([&] {
    const Cloud steep = with_gradient(again, "distance", GradientSettings{}, task);
    const Cloud smooth = with_filtered_field(steep, "gradient", FieldFilterSettings{}, task);
    const PropagationResult result = segment_by_propagation(
        smooth, scalar_values(smooth, "distance", task), scalar_values(smooth, "filtered", task),
        PropagationSettings{}, task);
    regions = result.regions.at(0)->count();
  });
  table.add(std::to_string(row.points) + " points, " + std::to_string(regions) + " regions",
            seconds, row.propagation_s);
}

}  // namespace

int main() {
  Table t6("T6"), t7("T7");
  for (const Row& row : kRows) {
    const Hall h = hall(row.points);
    statistical(h, row, t6);
    propagated(h, row, t7);
  }
  t6.close();
  t7.close();
}
