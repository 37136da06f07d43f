// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/icp.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/table_columns.h"
#include "registration/icp/result.h"
#include "registration/icp/rows.h"
#include "registration/icp/settle.h"
#include "registration/icp/thinning.h"

namespace jalon {

namespace {

constexpr size_t kFewest = 4000;      // cells of the coarsest level: enough for steps of a millimetre on a street
constexpr size_t kMore = 60'000, kMany = 300'000;
constexpr size_t kLeastPoints = 20;
constexpr double kMisfits = 3;        // of the first distance (A1)

// Step 2: the deepest level with at most so many occupied cells.
int level_of(const Octree& tree, size_t most, Task& task) {
  const std::vector<uint64_t> counts = tree.cell_counts(task);
  int level = 0;
  while (level < kMaxLevel && counts[static_cast<size_t>(level) + 1] <= most) ++level;
  return level;
}

IcpPoints points_of(const SurfacePlanes& planes, size_t most, Task& task) {
  const int level = level_of(*planes.tree, most, task);
  return {flattest_points(planes, level, task), std::ldexp(planes.tree->cube().edge, -level)};
}

void set_frame(const IcpClouds& clouds, const IcpPoints& moving, IcpState& state) {
  Vec3 sum;
  const size_t n = moving.count(clouds.moving);
  for (size_t i = 0; i < n; ++i) sum += clouds.moving.place(moving.position(i));
  state.centre = sum / static_cast<double>(n);
  double squares = 0;
  for (size_t i = 0; i < n; ++i) squares += squared_norm(clouds.moving.place(moving.position(i)) - state.centre);
  state.extent_m = std::max(std::sqrt(squares / static_cast<double>(n)), 1e-6);
}

double first_distance(const IcpClouds& clouds, const IcpPoints& reference, const IcpPoints& moving,
                      const Transform& inner, Task& task) {
  const IcpSearch search(clouds, reference, moving, 0, task);
  const IcpNeighbours near = search.find(inner, INFINITY, task);
  std::vector<double> distances{0};
  for (size_t i = 0; i < near.of_moving.size(); ++i)
    if (near.of_moving[i] != kNoPoint)
    distances.push_back(norm(inner.point(clouds.moving.place(moving.position(i))) -
                             clouds.reference.place(near.of_moving[i])));
  const auto middle = distances.begin() + static_cast<ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  // Clouds that lie on each other already, to the last bit perhaps, must still find each other.
  return std::max({kMisfits * *middle, clouds.reference.radius_m, clouds.moving.radius_m});
}

// Step 2, on the way to all points on a tenth of many: their steps cost little and leave the last ones little to do.
void iterate(const IcpClouds& clouds, const IcpSettings& settings, Task& task, IcpState& state) {
  const IcpPoints few_reference = points_of(clouds.reference, kFewest, task),
                  few_moving = points_of(clouds.moving, kFewest, task);
  set_frame(clouds, few_moving, state);
  state.distance_m = settings.max_distance_m > 0
                         ? settings.max_distance_m
                         : first_distance(clouds, few_reference, few_moving, state.inner, task);
  int level = 0;
  if (settings.coarse_to_fine) {
    if (!icp_iterate(clouds, few_reference, few_moving, level++, false, settings, task, state)) return;
    if (std::min(clouds.reference.size(), clouds.moving.size()) >= kMany) {
      const IcpPoints more_reference = points_of(clouds.reference, kMore, task),
                      more_moving = points_of(clouds.moving, kMore, task);
      if (!icp_iterate(clouds, more_reference, more_moving, level++, false, settings, task, state)) return;
    }
  }
  icp_iterate(clouds, {}, {}, level, true, settings, task, state);
}

}  // namespace

std::span<const ParamRow> icp_rows() { return kIcpRows; }

Registration register_icp(const CloudPtr& reference, const CloudPtr& moving, const Transform& start,
                          const IcpSettings& settings, Task& task) {
  double cell_m = 0;
  if (reference->size() < kLeastPoints || moving->size() < kLeastPoints)
    fail(Status::kInsufficientData, "%zu and %zu points; a registration needs %zu in each cloud", reference->size(),
         moving->size(), kLeastPoints);
  if (!is_finite(start.translation())) fail(Status::kInvalidArgument, "the start has a shift that is not finite");
  IcpClouds clouds;
  IcpSource of_reference, of_moving;
  {
    Span span(task, 0, 0.5, "local planes");
    cell_m = thinning_cell_m(*reference, *moving, settings, task);
    of_reference = thinned_source(reference, cell_m, task);
    of_moving = thinned_source(moving, cell_m, task);
    if (of_reference.cloud->size() < kLeastPoints || of_moving.cloud->size() < kLeastPoints)
      fail(Status::kInsufficientData, "thinned to its cells the clouds have %zu and %zu points; they need %zu",
           of_reference.cloud->size(), of_moving.cloud->size(), kLeastPoints);
    clouds.reference = surface_planes(of_reference.cloud->octree(task), settings.k, task);
    clouds.moving = surface_planes(of_moving.cloud->octree(task), settings.k, task);
  }
  IcpState state;
  state.inner = clouds.inner(start);
  {
    Span span(task, 0.5, 0.85, "iterations");
    iterate(clouds, settings, task, state);
  }
  {
    Span span(task, 0.85, 0.95, "patches of both clouds");
    icp_settle(clouds, settings, task, state);
  }
  Span span(task, 0.95, 1, "covariance");
  Registration out = icp_result(clouds, of_reference, of_moving, settings, state, task);
  add_value<double>(out.summary, "thinning_cell", "m", "edge of the cubes thinned to a point; 0: none", cell_m);
  return out;
}

}  // namespace jalon
