// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/normals_pca.h"

#include <algorithm>

#include "base/numbers.h"
#include "cloud/neighbour_planes.h"
#include "cloud/neighbourhoods.h"
#include "spatial/neighbours/range_sums.h"

namespace jalon {

namespace {

PcaNormals new_result(size_t count, bool with_curvature) {
  PcaNormals out;
  out.normal = std::make_shared<Column>(
      FieldInfo{"normal", ElementType::kFloat32, 3, "", "unit normal of the local plane"}, count);
  if (with_curvature)
    out.curvature = std::make_shared<Column>(
        FieldInfo{"curvature", ElementType::kFloat32, 1, "",
                  "surface variation lambda_0 / (lambda_0 + lambda_1 + lambda_2)"},
        count);
  return out;
}

/// Writes normals and curvatures in the caller's order.
class ColumnWriter {
 public:
  ColumnWriter(const Octree& tree, const PcaNormals& out)
      : order_(tree.order()),
        normal_(out.normal->values<float>().data()),
        curvature_(out.curvature ? out.curvature->values<float>().data() : nullptr) {}

  void operator()(const NeighbourPlane& plane) const {
    const size_t target = order_[plane.position];
    float* to = normal_ + 3 * target;
    for (int c = 0; c < 3; ++c)
      to[c] = plane.normal == nullptr ? kFloatNaN : static_cast<float>(plane.normal[c]);
    if (curvature_ != nullptr)
      curvature_[target] =
          plane.normal == nullptr ? kFloatNaN : static_cast<float>(plane.variation);
  }

 private:
  std::span<const uint32_t> order_;
  float *normal_, *curvature_;
};

}  // namespace

PcaNormals pca_normals(const Octree& tree, uint32_t k, bool with_curvature, Task& task) {
  PcaNormals out = new_result(tree.size(), with_curvature);
  const size_t used = std::min<size_t>(k, tree.size());  // the places behind are empty
  tree.for_each_knn(k, task, [&](const Octree::Batch& b) {
    NeighbourPlanes planes(tree, ColumnWriter(tree, out));
    for (size_t i = 0; i < b.count; ++i) planes.add(b.first + i, b.neighbours + i * b.k, used);
    planes.flush();
  });
  return out;
}

PcaNormals pca_normals_radius(const Octree& tree, double radius_m, bool with_curvature,
                              Task& task) {
  PcaNormals out = new_result(tree.size(), with_curvature);
  const RangeSums<2> sums(tree, task);
  tree.for_each_ranged_ball(
      radius_m, task,
      [&](const Octree::BallBatch& b) {
        NeighbourPlanes planes(tree, ColumnWriter(tree, out));
        NeighbourSums listed;
        for (size_t i = 0; i < b.count; ++i) {
          const size_t count = b.offsets[i + 1] - b.offsets[i];
          if (!repeats_before(tree, b, i))
            listed = planes.sums_of(b.first + i, b.neighbours + b.offsets[i], count);
          planes.add(b.first + i, listed);
        }
        planes.flush();
      },
      [&](const Octree::RangedBall& ball) {
        NeighbourPlanes planes(tree, ColumnWriter(tree, out));
        planes.add(ball.point, sums.over(ball.ranges, grid_place(tree, ball.point)));
        planes.flush();
      });
  return out;
}

}  // namespace jalon
