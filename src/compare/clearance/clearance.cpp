// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/clearance/clearance.h"

#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/setting_rows.h"
#include "base/table_columns.h"
#include "solid/surface_pair.h"
#include "solid/surface_points.h"

namespace jalon {

namespace {

using S = ClearanceSettings;

constexpr auto kRows = setting_rows(
    number_row<&S::margin_m>("margin_m", 0, 1e6, "m", "",
                             "distance: what comes this close, or closer, is listed"),
    number_row<&S::reach_m>(
        "reach_m", 0, 1e6, "m", "sweep",
        "the least clearance of each pose interval is found up to this distance"),
    number_row<&S::chord_m>("chord_m", 1e-6, 1, "m", "",
                            "arcs of faces become chords at most this distance from them"),
    number_row<&S::depth_tolerance_m>(
        "depth_tolerance_m", 1e-5, 1, "m", "model",
        "the depth in a closed surface that is not convex is at most this much too small"));

void put(const Vec3& v, double* out) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

constexpr size_t kRowsPerLook = size_t{1} << 16;

// What a column asks of each row, with a look for a cancel every so many rows: of millions a column takes tenths of a
// second.
template <class F>
auto with_looks(Task& task, F f) {
  return [&task, f, rows = size_t{0}](const auto& row, auto*... out) mutable {
    if (rows++ % kRowsPerLook == 0) task.checkpoint(1);
    return f(row, out...);
  };
}

// part, face and triangle of each row; prefix "" or "other_".
template <class Rows, class F>
void add_sources(FieldTable& table, const Rows& rows, const std::string& prefix, F source,
                 Task& task) {
  add_column<uint64_t>(table, rows, prefix + "part", "", "part, or 2^64 - 1",
                       with_looks(task, [&](const auto& row) { return source(row).part; }));
  add_column<uint64_t>(table, rows, prefix + "face", "", "row of the faces, or 2^64 - 1",
                       with_looks(task, [&](const auto& row) { return source(row).face; }));
  add_column<uint64_t>(table, rows, prefix + "triangle", "", "row of the triangles, or 2^64 - 1",
                       with_looks(task, [&](const auto& row) { return source(row).triangle; }));
}

PartSurface surface_of(const PartTriangles& part, Task& task) {
  return {part.vertices, part.triangles, task};
}

FieldTable near_points_table(const std::vector<NearPoint>& rows, const Cloud& cloud,
                             const PartTriangles& part, Task& task) {
  FieldTable t;
  add_column<uint64_t>(t, rows, "point", "", "point of the cloud",
                       with_looks(task, [](const NearPoint& r) { return r.point; }));
  add_column<double>(t, rows, "clearance", "m", "distance; negative inside",
                     with_looks(task, [](const NearPoint& r) { return r.distance_m; }));
  add_sources(
      t, rows, "", [&](const NearPoint& r) { return part.sources[r.triangle]; }, task);
  add_columns<double, 3>(
      t, rows, "xyz", "m", "the point",
      with_looks(task, [&](const NearPoint& r, double* o) { put(cloud.point(r.point), o); }));
  add_columns<double, 3>(t, rows, "foot", "m", "nearest point of the surface",
                         with_looks(task, [](const NearPoint& r, double* o) { put(r.foot, o); }));
  return t;
}

FieldTable near_triangles_table(const std::vector<NearTriangle>& rows, const PartTriangles& part,
                                const PartTriangles& other, Task& task) {
  FieldTable t;
  add_column<double>(t, rows, "clearance", "m", "distance; 0: they meet",
                     with_looks(task, [](const NearTriangle& r) { return r.distance_m; }));
  add_sources(
      t, rows, "", [&](const NearTriangle& r) { return part.sources[r.first]; }, task);
  add_sources(
      t, rows, "other_", [&](const NearTriangle& r) { return other.sources[r.second]; }, task);
  add_columns<double, 3>(
      t, rows, "xyz", "m", "nearest point of the other surface",
      with_looks(task, [](const NearTriangle& r, double* o) { put(r.second_point, o); }));
  add_columns<double, 3>(
      t, rows, "foot", "m", "nearest point of the surface",
      with_looks(task, [](const NearTriangle& r, double* o) { put(r.first_point, o); }));
  return t;
}

void add_inside(FieldTable& summary, bool closed, bool interferes, double depth, uint64_t near) {
  add_value<double>(summary, "depth", "m",
                    "how deep the deepest point lies inside; NaN: nothing has an inside", depth);
  add_value<uint8_t>(summary, "interferes", "", "1: they meet, or one lies in the other",
                     interferes);
  add_value<uint8_t>(summary, "closed", "", "1: the surface encloses a volume", closed);
  add_value<uint64_t>(summary, "near", "", "rows within the margin", near);
}

}  // namespace

void require_one_crs(const SharedText& a, const SharedText& b) {
  if (!a.empty() && !b.empty() && a != b)
    fail(Status::kInvalidArgument, "the CRS of the two (%.60s and %.60s) differ", a.c_str(),
         b.c_str());
}

std::span<const ParamRow> clearance_rows() { return kRows; }

ClearanceTables clearance_to_cloud(const Model& model, uint64_t part, const Cloud& cloud,
                                   const ClearanceSettings& settings, Task& task) {
  require_one_crs(model.crs, cloud.crs);
  if (cloud.size() == 0) fail(Status::kInsufficientData, "the cloud has no points");
  const PartTriangles triangles = triangles_of_part(model, part, settings.chord_m);
  const PartSurface surface = surface_of(triangles, task);
  const PointClearance found =
      clearance_of_points(surface, *cloud.octree(task), cloud.xyz(), settings.margin_m, task);

  ClearanceTables tables{near_points_table({found.least}, cloud, triangles, task), {}};
  const double depth = !surface.is_closed() ? kNaN : std::max(0.0, -found.least.distance_m);
  add_inside(tables.summary, surface.is_closed(), found.inside > 0 || found.least.distance_m == 0,
             depth, found.near.size());
  add_value<uint64_t>(tables.summary, "inside", "", "points inside", found.inside);
  tables.near = near_points_table(found.near, cloud, triangles, task);
  return tables;
}

ClearanceTables clearance_to_model(const Model& model, uint64_t part, const Model& other,
                                   uint64_t other_part, const ClearanceSettings& settings,
                                   Task& task) {
  require_one_crs(model.crs, other.crs);
  const PartTriangles first = triangles_of_part(model, part, settings.chord_m);
  const PartTriangles second = triangles_of_part(other, other_part, settings.chord_m);
  const PartSurface a = surface_of(first, task), b = surface_of(second, task);
  const PairClearance found =
      clearance_of_surfaces(a, b, {settings.margin_m, settings.depth_tolerance_m}, task);

  // Where they interfere, the row tells how deep and where deepest; the triangles are those of the nearest pair.
  NearTriangle row = found.least;
  if (found.meet) {
    row.distance_m = found.depth_m > 0 ? -found.depth_m : 0;
    if (found.depth_m > 0) {
      row.second_point = found.deepest;
      row.first_point = found.deepest_foot;
    }
  }
  ClearanceTables tables{near_triangles_table({row}, first, second, task), {}};
  add_inside(tables.summary, a.is_closed(), found.meet, found.depth_m, found.near.size());
  add_value<uint8_t>(tables.summary, "other_closed", "", "1: the other surface encloses a volume",
                     b.is_closed());
  tables.near = near_triangles_table(found.near, first, second, task);
  return tables;
}

}  // namespace jalon
