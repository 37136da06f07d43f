// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/fcl_distance.h"

#include <ccd/vec3.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "base/error.h"
#include "solid/fcl_precision.h"

static_assert(sizeof(ccd_real_t) == sizeof(double), "libccd is built for single precision");

namespace jalon {

namespace {

using Mesh = fcl::BVHModel<fcl::OBBRSSd>;

fcl::Vector3d to_fcl(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 from_fcl(const fcl::Vector3d& v) { return {v[0], v[1], v[2]}; }

std::shared_ptr<Mesh> mesh_of(const TriangleBoxes& boxes, const Vec3& origin) {
  std::vector<fcl::Vector3d> vertices;
  for (const Vec3& v : boxes.vertices()) vertices.push_back(to_fcl(v - origin));
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : boxes.triangles()) triangles.emplace_back(t[0], t[1], t[2]);
  auto mesh = std::make_shared<Mesh>();
  if (mesh->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size())) !=
          fcl::BVH_OK ||
      mesh->addSubModel(vertices, triangles) != fcl::BVH_OK || mesh->endModel() != fcl::BVH_OK)
    fail(Status::kInternal, "FCL took no mesh of %zu triangles", triangles.size());
  return mesh;
}

}  // namespace

void require_fcl() {
  if (!calculates_in_doubles(&ccdVec3PointTriDist2))
    fail(Status::kInternal,
         "the libccd that was loaded calculates in single precision; Jalon needs doubles");
}

TrianglePair nearest_pair(const TriangleBoxes& first, const TriangleBoxes& second) {
  const Vec3 corner = first.corners(0)[0],
             origin{std::floor(corner.x), std::floor(corner.y), std::floor(corner.z)};
  const auto a = mesh_of(first, origin), b = mesh_of(second, origin);
  fcl::DistanceRequestd request(true);
  fcl::DistanceResultd result;
  const fcl::Transform3d identity = fcl::Transform3d::Identity();
  fcl::distance(a.get(), identity, b.get(), identity, request, result);
  return {static_cast<uint32_t>(result.b1), static_cast<uint32_t>(result.b2),
          std::max(0.0, result.min_distance), from_fcl(result.nearest_points[0]) + origin,
          from_fcl(result.nearest_points[1]) + origin};
}

double triangle_distance(const std::array<Vec3, 3>& first, const std::array<Vec3, 3>& second,
                         Vec3& first_point, Vec3& second_point) {
  const Vec3 origin = first[0];
  fcl::Vector3d a[3], b[3], p, q;
  for (size_t i = 0; i < 3; ++i)
    a[i] = to_fcl(first[i] - origin), b[i] = to_fcl(second[i] - origin);
  const double distance = fcl::detail::TriangleDistanced::triDistance(a, b, p, q);
  first_point = from_fcl(p) + origin;
  second_point = from_fcl(q) + origin;
  return distance;
}

}  // namespace jalon
