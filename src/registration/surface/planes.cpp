// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/surface/planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "cloud/neighbour_planes.h"
#include "geometry/nearest_axis.h"
#include "registration/surface/face_plane.h"
#include "registration/surface/quadric_plane.h"

namespace jalon {

namespace {

constexpr float kPlanesNone = std::numeric_limits<float>::infinity();
constexpr size_t kNoiseSample = 1 << 12;
constexpr size_t kLookedUpPerLook = 256;   // some 20 us each in a large cloud
constexpr size_t kMedianSample = 1 << 14;  // a median of so many is within 1 % of that of all
// Of the median scatter. A scatter of 13 degrees of freedom is that large once in ten thousand; across an edge it is a
// multiple of it.
constexpr double kFlat = 1.75;
// ... about a paraboloid: less, since across an edge the six coefficients take some of the misfit up.
constexpr double kBent = 1.5;
constexpr size_t kPlanesUnknowns = 3;  // of a plane

// From sums of products about the centroid, in grid steps; least: the smallest eigenvalue.
SurfacePlane plane_of(const PlanePoints& points, const Vec3& n, double least, double step) {
  SurfacePlane out{{0, 0, 0}, 0, kPlanesNone, 0, 0, SurfaceShape::kPlane};
  const Symmetric3& s = points.scatter;
  const double tangent = s[0] + s[3] + s[5] - least;
  const double minors =
      (s[0] * s[3] - s[1] * s[1]) + (s[0] * s[5] - s[2] * s[2]) + (s[3] * s[5] - s[4] * s[4]);
  const double product = minors - least * tangent;  // of the two larger eigenvalues
  if (points.count <= kPlanesUnknowns || !(product > 0)) return out;
  const double variance = least / static_cast<double>(points.count - kPlanesUnknowns);
  for (int c = 0; c < 3; ++c) out.normal[c] = static_cast<float>(n[c]);
  out.height_m = static_cast<float>(dot(n, points.offset) * step);
  out.sigma_m = static_cast<float>(std::sqrt(variance) * step);
  out.tilt_rad = static_cast<float>(std::sqrt(0.5 * variance * tangent / product));
  out.radius_m = static_cast<float>(std::sqrt(tangent / static_cast<double>(points.count)) * step);
  return out;
}

SurfacePlane plane_of(const NeighbourPlane& from, double step) {
  const Symmetric3& s = *from.scatter;
  if (from.normal == nullptr) return {{0, 0, 0}, 0, kPlanesNone, 0, 0, SurfaceShape::kPlane};
  return plane_of({s, from.offset, from.count}, {from.normal[0], from.normal[1], from.normal[2]},
                  std::max(0.0, from.variation * (s[0] + s[3] + s[5])), step);
}

// Of the face of the point alone; none where there is no face.
SurfacePlane face_plane(const Octree& tree, size_t position, std::span<const uint32_t> neighbours,
                        double noise_m) {
  const double step = tree.grid_step();
  const auto points = points_of_face(tree, position, neighbours, noise_m / step);
  if (!points) return {{0, 0, 0}, 0, kPlanesNone, 0, 0, SurfaceShape::kPlane};
  const Eigen3 e = symmetric_eigen(points->scatter);
  SurfacePlane out = plane_of(*points, e.vectors[0], std::max(0.0, e.values[0]), step);
  out.shape = SurfaceShape::kFace;
  return out;
}

// Median scatter of an even sample of neighbourhoods.
double noise_of(const Octree& tree, uint32_t k, Task& task) {
  std::vector<float> sigmas;
  std::vector<Neighbour> found(k);
  size_t looked_up = 0;
  for (size_t i = 0; i < tree.size(); i += tree.size() / kNoiseSample + 1) {
    if (looked_up++ % kLookedUpPerLook == 0) task.checkpoint(0);
    const size_t n = tree.knn_positions(tree.cube().origin + tree.local(i), k, found);
    PlanePoints points;
    Vec3 sum;
    for (size_t j = 0; j < n; ++j) sum += tree.local(found[j].index) - tree.local(i);
    points.offset = sum / static_cast<double>(n);
    points.count = n;
    for (size_t j = 0; j < n; ++j) {
      const Vec3 d = tree.local(found[j].index) - tree.local(i) - points.offset;
      const double row[6] = {d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.y, d.y * d.z, d.z * d.z};
      for (size_t c = 0; c < 6; ++c) points.scatter[c] += row[c];
    }
    const Eigen3 e = symmetric_eigen(points.scatter);
    const SurfacePlane plane = plane_of(points, e.vectors[0], std::max(0.0, e.values[0]), 1);
    if (plane.sigma_m < kPlanesNone) sigmas.push_back(plane.sigma_m);
  }
  if (sigmas.empty()) return 0;
  const auto middle = sigmas.begin() + static_cast<ptrdiff_t>(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  return *middle;
}

template <class Value>
double median_of(const Buffer<SurfacePlane>& planes, Value value) {
  std::vector<float> values;
  const size_t stride = planes.size() / kMedianSample + 1;
  for (size_t i = 0; i < planes.size(); i += stride)
    if (planes[i].sigma_m < kPlanesNone) values.push_back(value(planes[i]));
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

SurfacePlanes surface_planes(std::shared_ptr<const Octree> tree, uint32_t k, Task& task) {
  SurfacePlanes out;
  out.tree = std::move(tree);
  out.planes = Buffer<SurfacePlane>(out.tree->size());
  const double step = out.tree->grid_step();
  const size_t used = std::min<size_t>(k, out.tree->size());  // the places behind are empty
  SurfacePlane* to = out.planes.data();
  out.noise_m = noise_of(*out.tree, static_cast<uint32_t>(used), task);
  out.flat_m = kFlat * out.noise_m;
  out.tree->for_each_knn(k, task, [&](const Octree::Batch& b) {
    const auto write = [&](const NeighbourPlane& plane) {
      SurfacePlane& here = to[plane.position];
      here = plane_of(plane, step);
      if (here.sigma_m <= out.flat_m) return;
      const std::span neighbours(b.neighbours + (plane.position - b.first) * b.k, used);
      here = tangent_plane(*out.tree, plane.position, neighbours, kBent * out.noise_m);
      if (here.sigma_m <= out.flat_m) return;
      here = face_plane(*out.tree, plane.position, neighbours, out.noise_m);
    };
    NeighbourPlanes<decltype(write)> planes(*out.tree, write);
    for (size_t i = 0; i < b.count; ++i) planes.add(b.first + i, b.neighbours + i * b.k, used);
    planes.flush();
  });
  out.radius_m = median_of(out.planes, [](const SurfacePlane& p) { return p.radius_m; });
  return out;
}

int deepest_level(const Octree& tree, size_t most_cells, Task& task) {
  const std::vector<uint64_t> counts = tree.cell_counts(task);
  int level = 0;
  while (level < kMaxLevel && counts[static_cast<size_t>(level) + 1] <= most_cells) ++level;
  return level;
}

std::vector<uint32_t> flattest_points(const SurfacePlanes& planes, int level, Task& task) {
  const std::vector<Octree::Cell> cells = planes.tree->cells(level, task);
  constexpr size_t kCellsPerChunk = 256;
  std::vector<std::vector<uint32_t>> parts((cells.size() + kCellsPerChunk - 1) / kCellsPerChunk);
  parallel_for(task, cells.size(), kCellsPerChunk, [&](size_t begin, size_t end) {
    auto& part = parts[begin / kCellsPerChunk];
    for (size_t c = begin; c < end; ++c) {
      uint32_t best[3] = {kNoPoint, kNoPoint, kNoPoint};
      for (size_t i = cells[c].first; i < cells[c].first + cells[c].count; ++i) {
        if (!planes.flat(i)) continue;
        uint32_t& held = best[nearest_axis(planes.planes[i].unit())];
        if (held == kNoPoint || planes.planes[i].sigma_m < planes.planes[held].sigma_m)
          held = static_cast<uint32_t>(i);
      }
      std::sort(best, best + 3);
      for (const uint32_t i : best)
        if (i != kNoPoint) part.push_back(i);
    }
  });
  std::vector<uint32_t> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

}  // namespace jalon
