// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/global_planarity.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "base/parallel.h"
#include "segment/settle/assignment.h"
#include "segment/settle/splitting.h"
#include "segment/settle/surface_fit.h"

// Global planarity (Yu, Ferencz & Malik 2008, after the variational shape approximation of Cohen-Steiner, Alliez &
// Desbrun 2004): clusters of coplanar points are given by the method before; then
// 1. each cluster is tried as two planes: its points, averaged over cells of its plane so that noise does not decide,
//    go to the nearer of the two, the planes are fitted anew, until nothing moves (2-means of plane equations);
// 2. where two planes fit much better and are apart by more than the noise, there are two clusters, tried in turn;
//    parts that lie in the plane of another cluster join it;
// 3. all points are shared out among all planes, which are fitted anew, a few times.

namespace jalon {

namespace {

constexpr double kPixelsPerCell = 2;  // of two spacings each: some 16 points a cell
constexpr size_t kLeastPerCell = 4;   // points: fewer do not tell their spread
constexpr size_t kLeastCells = 8;     // of a part: two planes through fewer are any two
constexpr int kMostTurns = 30;        // of 2-means; mostly it settles in five
constexpr double kCure = 0.5;         // of the misfit that two planes may leave
constexpr double kLeastApart = 2;     // noises: planes less apart have their points mixed
constexpr double kSamePlane = 1.1;    // sigmas: of each of two clusters about their common plane
constexpr double kLeastNoise = 0.04;  // of the tolerance, as in assignment.cpp
constexpr int kSharingRounds = 3;     // as in ending.cpp
constexpr double kDiagonal = 0.70710678118654752;

/// Points of one cell of a surface's plane; coordinates u, v and height over it.
struct PlanarCell {
  Moments moments;
  Vec3 mean;
  uint8_t side = 0;
};

struct PlanarCells {
  Raster raster;
  std::vector<PlanarCell> list;    ///< occupied, by their first point
  std::vector<uint32_t> of_pixel;  ///< index in the list, or kNoPoint
  std::vector<uint32_t> of_point;  ///< cell of each of the surface's points
  double noise_m = 0;
};

// Spread of heights within a cell: its middle value, as cells across a step hold two planes.
double noise_within(const SegmentScene& scene, const std::vector<PlanarCell>& cells) {
  std::vector<double> variances;
  for (const PlanarCell& cell : cells) {
    if (cell.moments.n < kLeastPerCell) continue;
    const auto n = static_cast<double>(cell.moments.n);
    variances.push_back(cell.moments.covariance()[5] * n / (n - 1));
  }
  const double least = kLeastNoise * scene.settings.distance_tolerance_m;
  if (variances.empty()) return least;
  const auto middle = variances.begin() + static_cast<ptrdiff_t>(variances.size() / 2);
  std::nth_element(variances.begin(), middle, variances.end());
  return std::max(least, std::sqrt(std::max(0.0, *middle)));
}

PlanarCells cells_of(const SegmentScene& scene, const Surface& surface, Task& task) {
  const std::vector<Vec2> uv = flat_points(scene, surface, task);
  PlanarCells out;
  out.raster = bounded_raster(uv, kPixelsPerCell * surface.pixel_m, 1);
  out.of_pixel.assign(out.raster.size(), kNoPoint);
  for (size_t i = 0; i < uv.size(); ++i) {
    const size_t pixel = out.raster.pixel_of(uv[i]);
    uint32_t& cell = out.of_pixel[pixel];
    if (cell == kNoPoint) {
      cell = static_cast<uint32_t>(out.list.size());
      out.list.emplace_back();
    }
    out.of_point.push_back(cell);
    out.list[cell].moments.add(
        {uv[i].u, uv[i].v, surface.plane.distance(scene.local(surface.positions[i]))});
  }
  for (PlanarCell& cell : out.list) cell.mean = cell.moments.centroid();
  out.noise_m = noise_within(scene, out.list);
  return out;
}

struct TwoPlanes {
  PlaneFit fit[2];
  size_t cells[2] = {0, 0};
  double misfit = INFINITY;  ///< sum over points of the squared distance of their cell
};

double squared(double x) { return x * x; }

bool fit_sides(const std::vector<PlanarCell>& cells, TwoPlanes& out) {
  Moments sums[2];
  out.cells[0] = out.cells[1] = 0;
  for (const PlanarCell& cell : cells) {
    sums[cell.side] += cell.moments;
    ++out.cells[cell.side];
  }
  for (size_t k = 0; k < 2; ++k)
    if (out.cells[k] < kLeastCells || !fit_plane(sums[k], out.fit[k])) return false;
  return true;
}

// Turns of fit and assignment from the cells' present sides; false when one side runs out of cells.
bool two_means(std::vector<PlanarCell>& cells, TwoPlanes& out) {
  for (int turn = 0; turn < kMostTurns; ++turn) {
    if (!fit_sides(cells, out)) return false;
    bool moved = false;
    out.misfit = 0;
    for (PlanarCell& cell : cells) {
      const double to[2] = {squared(out.fit[0].plane.distance(cell.mean)),
                            squared(out.fit[1].plane.distance(cell.mean))};
      const auto side = static_cast<uint8_t>(to[1] < to[0]);
      moved |= side != cell.side;
      cell.side = side;
      out.misfit += static_cast<double>(cell.moments.n) * to[side];
    }
    if (!moved) return true;
  }
  return fit_sides(cells, out);
}

// Root mean square distance of the cells of the side with fewer from the other side's plane.
double apart_m(const std::vector<PlanarCell>& cells, const TwoPlanes& two) {
  const uint8_t small = two.cells[1] < two.cells[0];
  double sum = 0;
  for (const PlanarCell& cell : cells)
    if (cell.side == small) sum += squared(two.fit[1 - small].plane.distance(cell.mean));
  return std::sqrt(sum / static_cast<double>(two.cells[small]));
}

// The best two planes in the place of one. Starts: by the side of the one plane, which finds steps, and by halves in
// four directions, which finds folds.
std::optional<TwoPlanes> better_planes(PlanarCells& cells) {
  Moments all;
  for (const PlanarCell& cell : cells.list) all += cell.moments;
  PlaneFit one;
  if (cells.list.size() < 2 * kLeastCells || !fit_plane(all, one)) return std::nullopt;
  double misfit = 0;
  for (const PlanarCell& cell : cells.list)
    misfit += static_cast<double>(cell.moments.n) * squared(one.plane.distance(cell.mean));
  const Vec3 starts[] = {one.plane.normal, one.axis_u, one.axis_v,
                         kDiagonal * (one.axis_u + one.axis_v),
                         kDiagonal * (one.axis_u - one.axis_v)};
  TwoPlanes best;
  std::vector<PlanarCell> sides;
  for (const Vec3& start : starts) {
    for (PlanarCell& cell : cells.list) cell.side = dot(cell.mean - one.centroid, start) > 0;
    TwoPlanes two;
    if (!two_means(cells.list, two) || !(two.misfit < best.misfit)) continue;
    best = two;
    sides = cells.list;
  }
  if (sides.empty() || best.misfit > kCure * misfit) return std::nullopt;
  if (apart_m(sides, best) < kLeastApart * cells.noise_m) return std::nullopt;
  cells.list = std::move(sides);
  return best;
}

bool beside_other(const PlanarCells& cells, size_t pixel, uint8_t side) {
  const size_t columns = cells.raster.columns, count = cells.of_pixel.size();
  for (const size_t row : {pixel - columns, pixel, pixel + columns})
    for (size_t p = row - 1; p != row + 2; ++p)  // what wraps round is empty: the margin
      if (p < count && cells.of_pixel[p] != kNoPoint && cells.list[cells.of_pixel[p]].side != side)
        return true;
  return false;
}

// Points go with their cell; where cells of both sides touch, to the nearer plane.
std::vector<uint8_t> sides_of_points(const SegmentScene& scene, const Surface& surface,
                                     const PlanarCells& cells, const TwoPlanes& two, Task& task) {
  std::vector<uint8_t> mixed(cells.list.size());
  for (size_t p = 0; p < cells.of_pixel.size(); ++p)
    if (const uint32_t c = cells.of_pixel[p]; c != kNoPoint)
      mixed[c] = beside_other(cells, p, cells.list[c].side);
  const std::vector<Vec2> uv = flat_points(scene, surface, task);
  std::vector<uint8_t> out(uv.size());
  for (size_t i = 0; i < uv.size(); ++i) {
    const uint32_t cell = cells.of_point[i];
    out[i] = cells.list[cell].side;
    if (mixed[cell] == 0) continue;
    const Vec3 p{uv[i].u, uv[i].v, surface.plane.distance(scene.local(surface.positions[i]))};
    out[i] = std::fabs(two.fit[1].plane.distance(p)) < std::fabs(two.fit[0].plane.distance(p));
  }
  return out;
}

// Plane, sigma and area from the points; false when they are too few for a segment.
bool describe_part(const SegmentScene& scene, double pixel_m, Surface& part, Task& task) {
  const SurfaceSettings& settings = scene.settings;
  if (part.positions.size() < std::max<size_t>(3, settings.min_points)) return false;
  Moments moments;
  moments.reference = scene.local(part.positions[0]);
  for (const uint32_t position : part.positions) moments.add(scene.local(position));
  PlaneFit fit;
  if (!fit_plane(moments, fit)) return false;
  part.plane = fit.plane;
  part.sigma_m = fit.sigma;
  part.pixel_m = pixel_m;
  part.area_m2 = occupied_area_m2(bounded_raster(flat_points(scene, part, task), pixel_m, 0));
  return part.area_m2 >= settings.min_area_m2;
}

// The two surfaces in the place of one, the larger first; nothing when it is one plane.
std::vector<Surface> parted(const SegmentScene& scene, const Surface& surface, Task& task) {
  if (!surface.is_plane()) return {};
  PlanarCells cells = cells_of(scene, surface, task);
  const std::optional<TwoPlanes> two = better_planes(cells);
  if (!two) return {};
  const std::vector<uint8_t> sides = sides_of_points(scene, surface, cells, *two, task);
  std::vector<Surface> parts(2);
  for (size_t i = 0; i < sides.size(); ++i)
    parts[sides[i]].positions.push_back(surface.positions[i]);
  for (Surface& part : parts)
    if (!describe_part(scene, surface.pixel_m, part, task)) return {};
  if (parts[1].positions.size() > parts[0].positions.size()) std::swap(parts[0], parts[1]);
  return parts;
}

// All surfaces, and what they were parted in, until none is parted any more; which of them are parts.
std::vector<uint8_t> part_all(const SegmentScene& scene, std::vector<Surface>& surfaces,
                              Task& task) {
  std::vector<uint8_t> is_part(surfaces.size(), 0);
  std::vector<size_t> open(surfaces.size());
  for (size_t s = 0; s < open.size(); ++s) open[s] = s;
  while (!open.empty()) {
    std::vector<std::vector<Surface>> parts(open.size());
    parallel_for(task, open.size(), 1,
                 [&](size_t k, size_t) { parts[k] = parted(scene, surfaces[open[k]], task); });
    std::vector<size_t> next;
    for (size_t k = 0; k < parts.size(); ++k) {
      if (parts[k].empty()) continue;
      next.push_back(open[k]);
      next.push_back(surfaces.size());
      is_part[open[k]] = 1;
      is_part.push_back(1);
      surfaces[open[k]] = std::move(parts[k][0]);
      surfaces.push_back(std::move(parts[k][1]));
    }
    open = std::move(next);
  }
  return is_part;
}

struct Cluster {
  Moments moments;
  PlaneFit fit;
  bool is_known = false;
};

Cluster cluster_of(const SegmentScene& scene, const Surface& surface) {
  Cluster out;
  const double half = scene.tree->cube().edge / 2;
  out.moments.reference = {half, half, half};
  if (!surface.is_plane()) return out;
  for (const uint32_t position : surface.positions) out.moments.add(scene.local(position));
  out.is_known = fit_plane(out.moments, out.fit);
  return out;
}

bool are_coplanar(const SegmentScene& scene, const Cluster& a, const Cluster& b, PlaneFit& fit) {
  Moments joint = a.moments;
  joint += b.moments;
  const double least = kLeastNoise * scene.settings.distance_tolerance_m;
  const auto agrees = [&](const Cluster& c) {
    return rms_about(c.moments, fit.plane) <= kSamePlane * std::max(c.fit.sigma, least);
  };
  return fit_plane(joint, fit) && agrees(a) && agrees(b);
}

// Parts and the clusters whose plane they lie in; what is far apart there is parted again by connectivity.
void join_coplanar(const SegmentScene& scene, const std::vector<uint8_t>& is_part,
                   std::vector<Surface>& surfaces, Task& task) {
  std::vector<Cluster> clusters(surfaces.size());
  parallel_for(task, surfaces.size(), 1,
               [&](size_t s, size_t) { clusters[s] = cluster_of(scene, surfaces[s]); });
  for (size_t i = 0; i < surfaces.size(); ++i) {
    task.checkpoint(0);
    for (size_t j = i + 1; j < surfaces.size() && clusters[i].is_known; ++j) {
      PlaneFit fit;
      if (!clusters[j].is_known || (is_part[i] == 0 && is_part[j] == 0) ||
          !are_coplanar(scene, clusters[i], clusters[j], fit))
        continue;
      Surface &into = surfaces[i], &from = surfaces[j];
      into.positions.insert(into.positions.end(), from.positions.begin(), from.positions.end());
      std::sort(into.positions.begin(), into.positions.end());
      into.area_m2 += from.area_m2;
      into.image = {};
      into.plane = fit.plane;
      into.sigma_m = fit.sigma;
      clusters[i].moments += clusters[j].moments;
      clusters[i].fit = fit;
      clusters[j].is_known = false;
      from.positions.clear();
    }
  }
  std::erase_if(surfaces, [](const Surface& s) { return s.positions.empty(); });
}

}  // namespace

void refine_global_planarity(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  const std::vector<uint8_t> is_part = part_all(scene, surfaces, task);
  if (std::find(is_part.begin(), is_part.end(), 1) == is_part.end()) return;
  join_coplanar(scene, is_part, surfaces, task);
  const auto share_out = [&] {
    for (int round = 0; round < kSharingRounds; ++round) {
      assign_points(scene, surfaces, task);
      if (!refit_surfaces(scene, surfaces, task) && round > 0) break;
    }
  };
  share_out();
  if (!scene.settings.connectivity || !split_surfaces(scene, surfaces, task)) return;
  refit_surfaces(scene, surfaces, task);
  share_out();
}

}  // namespace jalon
