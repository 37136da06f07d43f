// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/statistics.h"

#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/plane.h"

namespace jalon {

namespace {

constexpr size_t kStatisticsGrain = 1 << 15;

/// The centroid relative to an origin.
Vec3 local_centroid(const Cloud& cloud, const Vec3& origin, Task& task) {
  const Vec3 sum =
      parallel_reduce(task, cloud.size(), kStatisticsGrain, Vec3{}, [&](size_t begin, size_t end) {
        Vec3 part;
        for (size_t i = begin; i < end; ++i) part += cloud.point(i) - origin;
        return part;
      });
  return sum / static_cast<double>(cloud.size());
}

double power(double x, uint32_t n) {
  double result = 1;
  for (uint32_t i = 0; i < n; ++i) result *= x;
  return result;
}

void require_points(const Cloud& cloud) {
  if (cloud.size() == 0) fail(Status::kInsufficientData, "the cloud is empty");
}

}  // namespace

Vec3 local_origin(const Cloud& cloud, Task& task) {
  if (cloud.size() == 0) return {};
  const Box3 box = bounds(cloud, task);
  return {std::floor(box.min.x), std::floor(box.min.y), std::floor(box.min.z)};
}

CloudCovariance covariance_of(const Cloud& cloud, Task& task) {
  require_points(cloud);
  const Vec3 origin = local_origin(cloud, task);
  const Vec3 centre = local_centroid(cloud, origin, task);
  const Moments moments = parallel_reduce(
      task, cloud.size(), kStatisticsGrain, Moments{}, [&](size_t begin, size_t end) {
        Moments
            part;  // about the centroid: the sums of the first pass are all but zero here, so no digits cancel
        for (size_t i = begin; i < end; ++i) part.add(cloud.point(i) - origin - centre);
        return part;
      });
  return {origin, centre, origin + centre, moments.covariance()};
}

double moment_of(const Cloud& cloud, uint32_t a, uint32_t b, uint32_t c, bool centred, Task& task) {
  require_points(cloud);
  Vec3 origin, centre;
  if (centred) {
    origin = local_origin(cloud, task);
    centre = local_centroid(cloud, origin, task);
  }
  const double sum =
      parallel_reduce(task, cloud.size(), kStatisticsGrain, 0.0, [&](size_t begin, size_t end) {
        double part = 0;
        for (size_t i = begin; i < end; ++i) {
          const Vec3 p = cloud.point(i) - origin - centre;
          part += power(p.x, a) * power(p.y, b) * power(p.z, c);
        }
        return part;
      });
  return sum / static_cast<double>(cloud.size());
}

}  // namespace jalon
