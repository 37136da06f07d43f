// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Distance maps against the distances to all points, one by one, and to a sheet that fills its cells.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "fieldtools/chamfer.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using MapMethod = DistanceMapSettings::Method;

DistanceMapSettings map_settings(MapMethod method, double cell_m) {
  DistanceMapSettings out;
  out.method = method;
  out.cell_m = cell_m;
  return out;
}

double nearest_by_force(const Cloud& reference, const Vec3& p) {
  double best = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < reference.size(); ++i) best = std::min(best, norm(reference.point(i) - p));
  return best;
}

// Whether a map may say this. Chamfer: a point and a query are each up to half a diagonal from their cells' centres,
// and paths are up to 11 % off. Fast marching never cuts the way short but where two fronts meet, there by less than
// 1 - 1 / sqrt(3) of a cell; it starts at the centre, up to a diagonal of detour, is 0.55 cells late at the first
// corner (1 + 1 / sqrt(2) + 1 / sqrt(3) for sqrt(3)) and a few percent later.
bool map_may_say(MapMethod method, double cell_m, double found_m, double truth_m) {
  const double diagonal_m = std::sqrt(3.0) * cell_m;
  if (method == MapMethod::kChamfer)
    return std::fabs(found_m - truth_m) <= diagonal_m + 0.11 * truth_m;
  return found_m >= truth_m - 0.43 * cell_m &&
         found_m <= 1.06 * truth_m + diagonal_m + 0.55 * cell_m;
}

// A floor of points 2.5 cm apart, whose cells of 10 cm are all occupied.
Cloud map_floor() {
  std::vector<Vec3> points;
  for (int i = 0; i <= 80; ++i)
    for (int j = 0; j <= 80; ++j) points.push_back({0.025 * i, 0.025 * j, 0});
  return cloud_of(points);
}

}  // namespace

TEST_CASE("with_map_distance__within_cells_and_paths_of_the_nearest_point") {
  const Cloud reference = cloud_of(random_points(60, 3, 1));
  const auto queries = shifted(random_points(400, 3, 2), {0.5, -0.5, 0.25});  // beyond its box too
  Task task;
  for (const MapMethod method : {MapMethod::kChamfer, MapMethod::kFastMarching}) {
    const Cloud out =
        with_map_distance(cloud_of(queries), reference, map_settings(method, 0.1), task);
    const auto found = out.fields.require("map_distance").values<double>();
    double off = 0;
    for (size_t i = 0; i < queries.size(); ++i) {
      const double truth = nearest_by_force(reference, queries[i]);
      CHECK(map_may_say(method, 0.1, found[i], truth));
      off += std::fabs(found[i] - truth) / static_cast<double>(queries.size());
    }
    CHECK(off < 0.12);  // detours of half a diagonal at the start, as late at the first corner
  }
}

TEST_CASE("with_map_distance__above_a_floor__the_height_of_the_cell_or_of_the_point_itself") {
  const Cloud reference = map_floor();
  std::vector<Vec3> queries;
  for (int i = 1; i < 100; ++i) queries.push_back({0.4 + 0.01 * i, 1.01, 0.0101 * i});
  Task task;
  const Cloud steps =
      with_map_distance(cloud_of(queries), reference, map_settings(MapMethod::kChamfer, 0.1), task);
  const Cloud smooth = with_map_distance(cloud_of(queries), reference,
                                         map_settings(MapMethod::kFastMarching, 0.1), task);
  const auto whole = steps.fields.require("map_distance").values<double>(),
             read = smooth.fields.require("map_distance").values<double>();
  for (size_t i = 0; i < queries.size(); ++i) {
    // Whole cells above the floor's own: floor(z / cell) cells of 10 cm.
    CHECK(whole[i] == doctest::Approx(0.1 * std::floor(queries[i].z / 0.1)).scale(1).epsilon(1e-6));
    // Centres of the floor's cells are 5 cm above it; a front over a sheet is flat but for the spread of the starts,
    // half a spacing sideways: hypot(5, 1.25) cm.
    if (queries[i].z > 0.05) CHECK(std::fabs(read[i] - queries[i].z) < 0.004);
  }
}

TEST_CASE("distance_map_cloud__centres_of_cells_of_one_grid_around_the_cloud_within_the_limit") {
  const Cloud reference = cloud_of(random_points(40, 2, 3));
  DistanceMapSettings set = map_settings(MapMethod::kFastMarching, 0.125);
  set.max_distance_m = 0.3;
  set.name = "away";
  Task task;
  const Cloud near = distance_map_cloud(reference, set, task);
  set.max_distance_m = 0;
  const Cloud all = distance_map_cloud(reference, set, task);
  const Box3 box = bounds(reference, task);
  const auto distances = all.fields.require("away").values<float>();
  size_t within = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    const Vec3 p = all.point(i);
    within += distances[i] <= 0.3f;
    for (int k = 0; k < 3; ++k) {
      const double cells = (p[k] - box.min[k]) / 0.125 - 0.5;
      CHECK(std::fabs(cells - std::round(cells)) < 1e-9);
    }
    const double truth = nearest_by_force(reference, p);
    CHECK(map_may_say(set.method, 0.125, static_cast<double>(distances[i]), truth));
  }
  CHECK(near.size() == within);
  CHECK(within < all.size());
  CHECK(near.fields.require("away").info().unit == "m");
}

TEST_CASE("with_map_distance__beyond_max_distance_no_value_and_what_is_wrong_is_told") {
  const Cloud reference = cloud_of(random_points(30, 1, 4)),
              compared = cloud_of(random_points(200, 3, 5));
  Task task;
  DistanceMapSettings set = map_settings(MapMethod::kFastMarching, 0.1), limited = set;
  limited.max_distance_m = 0.75;
  const Cloud a = with_map_distance(compared, reference, set, task),
              b = with_map_distance(compared, reference, limited, task);
  size_t beyond = 0;
  for (size_t i = 0; i < 200; ++i) {
    const double full = a.fields.require("map_distance").number(i),
                 cut = b.fields.require("map_distance").number(i);
    beyond += full > 0.75;
    if (full > 0.75) CHECK(std::isnan(cut));
    else CHECK(cut == full);
  }
  CHECK(beyond > 20);
  const auto map = [&](const DistanceMapSettings& settings, const Cloud& from) {
    return [&, settings] { with_map_distance(compared, from, settings, task); };
  };
  CHECK(refuses(map(set, Cloud()), Status::kInsufficientData, "no points"));
  set.cell_m = 1e-6;
  CHECK(refuses(map(set, reference), Status::kLimit, "too many cells"));
  set.name = "";
  CHECK(refuses(map(set, reference), Status::kInvalidArgument, "name"));
}
