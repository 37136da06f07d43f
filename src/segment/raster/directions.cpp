// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/directions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/plane.h"

namespace jalon {

namespace {

constexpr size_t kMostNormals = 1 << 16;  // sampled evenly: a direction of 1 % has 600 of them
constexpr double kPeakCosine = 0.966;     // 15 degrees about a peak: what its mean is taken of
constexpr double kCoveredCosine =
    0.866;                             // 30 degrees: an image foreshortens less than by a seventh
constexpr double kLeastShare = 0.002;  // of the normals: fewer are bits of clutter
constexpr int kCells = 12;             // along a side of the cube's faces: 7.5 degrees
constexpr int kMeans = 4;

Vec3 with_positive_largest(const Vec3& n) {
  const double ax = std::fabs(n.x), ay = std::fabs(n.y), az = std::fabs(n.z);
  const double largest = az >= ax && az >= ay ? n.z : (ay >= ax ? n.y : n.x);
  return largest < 0 ? -1.0 * n : n;
}

std::vector<Vec3> sampled_normals(const SegmentScene& scene) {
  const size_t step = (scene.size() + kMostNormals - 1) / kMostNormals;
  std::vector<Vec3> normals;
  for (size_t i = 0; i < scene.size(); i += step) {
    if (scene.owner[i] != 0 || std::isnan(scene.normals[3 * i])) continue;
    const float* m = &scene.normals[3 * i];
    normals.push_back(
        {static_cast<double>(m[0]), static_cast<double>(m[1]), static_cast<double>(m[2])});
  }
  return normals;
}

// Cell of a direction on the three faces of a half cube.
size_t cell_of(const Vec3& direction) {
  const Vec3 n = with_positive_largest(direction);
  const double ax = std::fabs(n.x), ay = std::fabs(n.y), az = std::fabs(n.z);
  const size_t face = az >= ax && az >= ay ? 2 : (ay >= ax ? 1 : 0);
  const double p = face == 0 ? n.y / n.x : n.x / (face == 1 ? n.y : n.z);
  const double q = face == 2 ? n.y / n.z : n.z / (face == 0 ? n.x : n.y);
  const auto at = [](double t) {
    return static_cast<size_t>(std::clamp(static_cast<int>((t + 1) / 2 * kCells), 0, kCells - 1));
  };
  return (face * kCells + at(p)) * kCells + at(q);
}

// The busiest cell's mean, then the mean of what is about it.
Vec3 peak_of(const std::vector<Vec3>& normals) {
  std::array<uint32_t, 3 * kCells * kCells> votes{};
  for (const Vec3& n : normals) ++votes[cell_of(n)];
  const auto best =
      static_cast<size_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  Vec3 sum{};
  for (const Vec3& n : normals)
    if (cell_of(n) == best) sum += with_positive_largest(n);
  Vec3 peak = normalized(sum);
  for (int round = 0; round < kMeans; ++round) {
    sum = {};
    for (const Vec3& n : normals) {
      const double cosine = dot(n, peak);
      if (std::fabs(cosine) >= kPeakCosine) sum += (cosine < 0 ? -1.0 : 1.0) * n;
    }
    peak = normalized(sum);
  }
  return with_positive_largest(peak);
}

Vec3 normal_of_all(const SegmentScene& scene) {
  Moments moments;
  moments.reference = scene.local(0);
  const size_t step = (scene.size() + kMostNormals - 1) / kMostNormals;
  for (size_t i = 0; i < scene.size(); i += step) moments.add(scene.local(i));
  PlaneFit fit;
  return fit_plane(moments, fit) ? with_positive_largest(fit.plane.normal) : Vec3{0, 0, 1};
}

}  // namespace

std::vector<Vec3> dominant_directions(const SegmentScene& scene, size_t most, Task& task) {
  std::vector<Vec3> normals = sampled_normals(scene), directions;
  const double least = std::max(1.0, kLeastShare * static_cast<double>(normals.size()));
  while (directions.size() < most && static_cast<double>(normals.size()) >= least) {
    task.checkpoint(static_cast<double>(directions.size()) / static_cast<double>(most));
    const Vec3 peak = peak_of(normals);
    const size_t before = normals.size();
    std::erase_if(normals,
                  [&](const Vec3& n) { return std::fabs(dot(n, peak)) >= kCoveredCosine; });
    if (normals.size() == before) break;
    if (static_cast<double>(before - normals.size()) >= least) directions.push_back(peak);
  }
  if (directions.empty()) directions.push_back(normal_of_all(scene));
  return directions;
}

Vec3 toward_viewers(const Cloud& cloud, const Vec3& origin, const Vec3& direction,
                    const Vec3& middle) {
  double points = 0;
  for (const Station& station : cloud.stations) {
    if (!station.has_pose) continue;
    const double side = dot(station.pose.translation() - origin - middle, direction);
    points += (side < 0 ? -1.0 : 1.0) * static_cast<double>(station.count);
  }
  return points < 0 ? -1.0 * direction : direction;
}

}  // namespace jalon
