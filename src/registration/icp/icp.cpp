// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/icp.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/table_columns.h"
#include "registration/icp/confirm.h"
#include "registration/icp/result.h"
#include "registration/icp/rows.h"
#include "registration/icp/settle.h"
#include "registration/icp/thinning.h"

namespace jalon {

namespace {

constexpr size_t kFewest =
    4000;  // cells of the coarsest level: enough for steps of a millimetre on a street
constexpr size_t kMore = 60'000, kMany = 300'000;
constexpr size_t kIcpLeastPoints = 20;
constexpr double kMisfits = 3;  // of the first distance

// Step 2: a point for each cell of the deepest level with at most so many.
LevelPoints points_of(const SurfacePlanes& surface, size_t most, Task& task) {
  const int level = deepest_level(*surface.tree, most, task);
  return {flattest_points(surface, level, task), std::ldexp(surface.tree->cube().edge, -level)};
}

IcpLevel level_of_cells(const IcpClouds& clouds, size_t most, int number, Task& task) {
  LevelPoints reference = points_of(clouds.reference, most, task);
  LevelPoints moving = points_of(clouds.moving, most, task);
  return {std::move(reference), std::move(moving), number, false};
}

// What turns are about, and what makes them lengths, from few points.
void set_frame(const LevelPoints& points, IcpProblem& problem) {
  const SurfacePlanes& moving = problem.clouds.moving;
  Vec3 sum;
  const size_t n = points.count(moving);
  for (size_t i = 0; i < n; ++i) sum += moving.place(points.position(i));
  problem.centre = sum / static_cast<double>(n);
  double squares = 0;
  for (size_t i = 0; i < n; ++i)
    squares += squared_norm(moving.place(points.position(i)) - problem.centre);
  problem.extent_m = std::max(std::sqrt(squares / static_cast<double>(n)), 1e-6);
}

double first_distance(const IcpClouds& clouds, const IcpLevel& level,
                      const Transform& T_reference_moving, Task& task) {
  const IcpSearch search(clouds, level, 0, task);
  const Buffer<uint32_t> near = search.find(T_reference_moving, INFINITY, task).of_moving;
  std::vector<double> distances{0};
  for (size_t i = 0; i < near.size(); ++i) {
    if (near[i] == kNoPoint) continue;
    const Vec3 place = T_reference_moving.point(clouds.moving.place(level.moving.position(i)));
    distances.push_back(norm(place - clouds.reference.place(near[i])));
  }
  const auto middle = distances.begin() + static_cast<ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  // Clouds that lie on each other already, to the last bit perhaps, must still find each other.
  return std::max({kMisfits * *middle, clouds.reference.radius_m, clouds.moving.radius_m});
}

// Step 1: from the raw clouds to surfaces.
IcpProblem problem_of(const CloudPtr& reference, const CloudPtr& moving,
                      const IcpSettings& settings, Task& task) {
  IcpProblem out;
  out.settings = settings;
  out.cells = thinning_cells(*reference, *moving, settings, task);
  out.thinned_reference = thinned(reference, out.cells, settings.k, task);
  out.thinned_moving = thinned(moving, out.cells, settings.k, task);
  const Cloud &few_reference = *out.thinned_reference.cloud,
              &few_moving = *out.thinned_moving.cloud;
  if (few_reference.size() < kIcpLeastPoints || few_moving.size() < kIcpLeastPoints)
    fail(Status::kInsufficientData,
         "thinned to its cells the clouds have %zu and %zu points; they need %zu",
         few_reference.size(), few_moving.size(), kIcpLeastPoints);
  out.clouds.reference = surface_planes(few_reference.octree(task), settings.k, task);
  out.clouds.moving = surface_planes(few_moving.octree(task), settings.k, task);
  return out;
}

// Step 2, on the way to all points on a tenth of many: their steps cost little and leave the last ones little to do.
// Returns the level of all points.
IcpLevel iterate(IcpProblem& problem, IcpState& state, Task& task) {
  const IcpSettings& settings = problem.settings;
  const IcpClouds& clouds = problem.clouds;
  const IcpLevel few = level_of_cells(clouds, kFewest, 0, task);
  set_frame(few.moving, problem);
  state.distance_m = settings.max_distance_m > 0
                         ? settings.max_distance_m
                         : first_distance(clouds, few, state.T_reference_moving, task);
  IcpLevel all;
  if (settings.coarse_to_fine) {
    if (!icp_iterate(problem, few, state, task)) return all;
    ++all.number;
    if (std::min(clouds.reference.size(), clouds.moving.size()) >= kMany) {
      const IcpLevel more = level_of_cells(clouds, kMore, all.number++, task);
      if (!icp_iterate(problem, more, state, task)) return all;
    }
  }
  icp_iterate(problem, all, state, task);
  return all;
}

}  // namespace

std::span<const ParamRow> icp_rows() { return kIcpRows; }

Registration register_icp(const CloudPtr& reference, const CloudPtr& moving,
                          const Transform& T_start, const IcpSettings& settings, Task& task) {
  if (reference->size() < kIcpLeastPoints || moving->size() < kIcpLeastPoints)
    fail(Status::kInsufficientData, "%zu and %zu points; a registration needs %zu in each cloud",
         reference->size(), moving->size(), kIcpLeastPoints);
  if (!is_finite(T_start.translation()))
    fail(Status::kInvalidArgument, "the start has a shift that is not finite");
  IcpProblem problem;
  {
    ProgressSpan span(task, 0, 0.5, "local planes");
    problem = problem_of(reference, moving, settings, task);
  }
  IcpState state;
  state.T_reference_moving = problem.clouds.to_local(T_start);
  IcpLevel all;
  {
    ProgressSpan span(task, 0.5, 0.85, "iterations");
    all = iterate(problem, state, task);
  }
  {
    ProgressSpan span(task, 0.85, 0.95, "patches of both clouds");
    icp_settle(problem, state, task);
  }
  ProgressSpan span(task, 0.95, 1, "covariance, verdict");
  const IcpJudged judged = icp_judged(*reference, *moving, problem, state.sigma_m, task);
  const double better_m = icp_confirm(problem, judged, all, state, task);
  Registration out = icp_result(problem, state, task);
  add_value<double>(
      out.summary, "thinning_cell", "m",
      "edge of the cubes thinned to a point, of the least where points lie in lines; 0: none",
      problem.cells.edge_m);
  icp_judge(judged, state, better_m, out, task);
  return out;
}

}  // namespace jalon
