// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/surface_classes.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/parallel.h"
#include "cloud/neighbour_planes.h"
#include "spatial/neighbours/range_sums.h"

// Classes of points after Belton & Lichti 2006 (Classification and segmentation of terrestrial laser scanner point
// clouds using local variance information, ISPRS XXXVI-5):
// 1. principal axes of the neighbours of each point, l0 <= l1 <= l2 their variances;
// 2. the noise of the cloud, from the spread across the local planes of all points;
// 3. boundary: the approximate curvature l0 / (l0 + l1 + l2) is that of a fold, and the spread is more than noise;
//    edge: the point is not in the middle of its neighbours, within their plane; surface: all others.
// The text compares with thresholds by hand; here both tests are those of their distributions.

namespace jalon {

namespace {

// Of one surface's points, one in a thousand is taken for two; one in a hundred for its end, which few neighbours
// show less clearly.
constexpr double kFoldDoubtSigmas = 3.0902;  // 0.001 of the standard normal distribution
constexpr double kEndDoubt = 0.01;
// Approximate curvature on a fold of 30 degrees, seen from the fold: half discs of radius r on both sides have
// 0.005 r^2 across and 0.5 r^2 along. Rounder surfaces (a pipe three times as wide as its neighbourhoods) have less.
constexpr double kFold = 0.01;
// Below, no spread is left to tell a border by.
constexpr size_t kLeastNeighbours = 5;
constexpr size_t kClassPointsPerChunk = 1 << 14;

struct Shape {
  float squared_sigma;    // across the plane, unbiased, grid steps^2; NaN = no plane
  float sure_squared;     // the noise that the spread across would be too large for
  uint8_t folded, aside;  // curvature of a fold; not in the middle
};

// Of the sum of squares across a plane through n points, over the variance: chi-square with n - 3 degrees of freedom,
// by Wilson & Hilferty 1931, right to a hundredth.
double spread_limit(size_t n) {
  const double dof = static_cast<double>(n - 3), part = 2 / (9 * dof);
  const double root = 1 - part + kFoldDoubtSigmas * std::sqrt(part);
  return dof * root * root * root;
}

// Of Hotelling's T^2 of a mean in two dimensions: (n - 2) / (2 (n - 1)) T^2 has the F distribution with 2 and n - 2
// degrees of freedom, whose tail is (1 + 2 F / (n - 2))^(-(n - 2) / 2).
double offset_limit(size_t n) {
  return static_cast<double>(n - 1) * (std::pow(kEndDoubt, -2 / static_cast<double>(n - 2)) - 1);
}

// T^2 of the neighbours' centroid about the point, within their plane: the offset across it is left out by a projector.
double offset_in_plane(const NeighbourPlane& plane, const Vec3& normal) {
  const Symmetric3& s = *plane.scatter;
  const Vec3 helper = std::fabs(normal.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 u = normalized(cross(helper, normal)), v = cross(normal, u);
  const auto product = [&](const Vec3& a, const Vec3& b) {
    return a.x * (s[0] * b.x + s[1] * b.y + s[2] * b.z) +
           a.y * (s[1] * b.x + s[3] * b.y + s[4] * b.z) +
           a.z * (s[2] * b.x + s[4] * b.y + s[5] * b.z);
  };
  const double uu = product(u, u), uv = product(u, v), vv = product(v, v);
  const double a = dot(plane.offset, u), b = dot(plane.offset, v);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return 0;
  const auto n = static_cast<double>(plane.count);
  return n * (n - 1) * (a * a * vv - 2 * a * b * uv + b * b * uu) / determinant;
}

class ShapeWriter {
 public:
  explicit ShapeWriter(Shape* shapes) : shapes_(shapes) {}
  void operator()(const NeighbourPlane& plane) {
    Shape& shape = shapes_[plane.position];
    shape = {kFloatNaN, 0, 0, 0};
    if (plane.normal == nullptr || plane.count < kLeastNeighbours) return;
    const Symmetric3& s = *plane.scatter;
    const double across = plane.variation * (s[0] + s[3] + s[5]);  // sum of squares
    shape.squared_sigma = static_cast<float>(across / static_cast<double>(plane.count - 3));
    shape.sure_squared = static_cast<float>(across / spread_limit(plane.count));
    shape.folded = plane.variation > kFold;
    shape.aside = offset_in_plane(plane, {plane.normal[0], plane.normal[1], plane.normal[2]}) >
                  offset_limit(plane.count);
  }

 private:
  Shape* shapes_;
};

std::vector<Shape> shapes_of(const Octree& tree, uint32_t k, double radius_m, Task& task) {
  std::vector<Shape> shapes(tree.size());
  if (!(radius_m > 0)) {
    const size_t used = std::min<size_t>(k, tree.size());  // the places behind are empty
    tree.for_each_knn(k, task, [&](const Octree::Batch& b) {
      NeighbourPlanes planes(tree, ShapeWriter(shapes.data()));
      for (size_t i = 0; i < b.count; ++i) planes.add(b.first + i, b.neighbours + i * b.k, used);
      planes.flush();
    });
    return shapes;
  }
  const RangeSums<2> sums(tree, task);
  tree.for_each_ranged_ball(
      radius_m, task,
      [&](const Octree::BallBatch& b) {
        NeighbourPlanes planes(tree, ShapeWriter(shapes.data()));
        for (size_t i = 0; i < b.count; ++i)
          planes.add(b.first + i, b.neighbours + b.offsets[i], b.offsets[i + 1] - b.offsets[i]);
        planes.flush();
      },
      [&](const Octree::RangedBall& ball) {
        NeighbourPlanes planes(tree, ShapeWriter(shapes.data()));
        planes.add(ball.point, sums.over(ball.ranges, grid_place(tree, ball.point)));
        planes.flush();
      });
  return shapes;
}

// Most points of a scan lie on surfaces: their middle value is that of noise alone.
float median_squared_sigma(const std::vector<Shape>& shapes) {
  std::vector<float> known;
  known.reserve(shapes.size());
  for (const Shape& shape : shapes)
    if (!std::isnan(shape.squared_sigma)) known.push_back(shape.squared_sigma);
  if (known.empty()) return 0;
  const auto middle = known.begin() + static_cast<ptrdiff_t>(known.size() / 2);
  std::nth_element(known.begin(), middle, known.end());
  return *middle;
}

SurfaceClass class_of(const Shape& shape, float squared_noise) {
  if (std::isnan(shape.squared_sigma)) return SurfaceClass::kUnknown;
  if (shape.folded != 0 && shape.sure_squared > squared_noise) return SurfaceClass::kBoundary;
  return shape.aside != 0 ? SurfaceClass::kEdge : SurfaceClass::kSurface;
}

}  // namespace

std::shared_ptr<Column> surface_classes(const Octree& tree, uint32_t k, double radius_m,
                                        Task& task) {
  auto column = std::make_shared<Column>(
      FieldInfo{"surface_class", ElementType::kUint8, 1, "",
                "1 = surface, 2 = edge of one surface, 3 = boundary of several, 0 = unknown"},
      tree.size());
  const auto classes = column->values<uint8_t>();
  const std::vector<Shape> shapes = shapes_of(tree, k, radius_m, task);
  const float squared_noise = median_squared_sigma(shapes);
  const auto order = tree.order();
  parallel_for(task, shapes.size(), kClassPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      classes[order[i]] = static_cast<uint8_t>(class_of(shapes[i], squared_noise));
  });
  return column;
}

}  // namespace jalon
