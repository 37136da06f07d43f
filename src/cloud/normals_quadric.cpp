// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

#include "base/numbers.h"
#include "cloud/neighbourhoods.h"
#include "cloud/normals_parts.h"

namespace jalon {

namespace {

struct NormalsQuadricScratch {
  std::vector<Vec3> points, work;
  Vec3 last;
};

Vec3 normal_of(const PrincipalFrame& frame, const LocalQuadric& fit) {
  const Vec3 n = fit.quadric.normal(fit.x, fit.y);
  return normalized(frame.u * n.x + frame.v * n.y + frame.n * n.z);
}

Vec3 quadric_normal(const Octree& tree, const Neighbourhood& around,
                    NormalsQuadricScratch& scratch) {
  Moments moments;
  moments.reference = tree.local(around.point);
  scratch.points.clear();
  for (const uint32_t j : around.neighbours) {
    scratch.points.push_back(tree.local(j));
    moments.add(scratch.points.back());
  }
  PrincipalFrame frame;
  if (!principal_frame(moments, frame)) return {kNaN, kNaN, kNaN};
  LocalQuadric fit;
  if (!local_quadric(frame, scratch.points, moments.reference, scratch.work, fit)) return frame.n;
  return normal_of(frame, fit);
}

Vec3 quadric_normal(const SummedBalls& sums, const Octree::RangedBall& ball) {
  PrincipalFrame frame;
  if (!principal_frame(sums.moments(ball), frame)) return {kNaN, kNaN, kNaN};
  LocalQuadric fit;
  return sums.quadric(frame, ball, fit) ? normal_of(frame, fit) : frame.n;
}

}  // namespace

std::shared_ptr<Column> new_normal_column(size_t count) {
  FieldInfo info{"normal", ElementType::kFloat32, 3, "", "unit normal of the surface"};
  return std::make_shared<Column>(std::move(info), count);
}

std::shared_ptr<Column> quadric_normals(const Octree& tree, uint32_t k, double radius_m,
                                        Task& task) {
  auto column = new_normal_column(tree.size());
  const auto out = column->values<float>();
  const auto order = tree.order();
  const auto write = [&](size_t point, const Vec3& n) {
    float* to = out.data() + 3 * size_t{order[point]};
    to[0] = static_cast<float>(n.x);
    to[1] = static_cast<float>(n.y);
    to[2] = static_cast<float>(n.z);
  };
  for_each_summed_neighbourhood<NormalsQuadricScratch>(
      tree, k, radius_m, true, task,
      [&](const Neighbourhood& around, NormalsQuadricScratch& scratch) {
        if (!around.repeats) scratch.last = quadric_normal(tree, around, scratch);
        write(around.point, scratch.last);
      },
      [&](const SummedBalls& sums, const Octree::RangedBall& ball) {
        write(ball.point, quadric_normal(sums, ball));
      });
  return column;
}

}  // namespace jalon
