// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/primitive_fits.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/serial.h"
#include "base/setting_rows.h"
#include "base/text_number.h"
#include "geometry/circle.h"
#include "segment/surface/connectivity.h"
#include "segment/surface/surface_map.h"

namespace jalon {

namespace {

constexpr size_t kPrimitiveFitsPointsPerChunk = 1 << 13;
constexpr size_t kNormalsPerChunk = 1 << 10;
constexpr double kPointsPerPixel = 4;  // pixels of twice the spacing, as the segmenter's
constexpr int kPixelRounds = 6;

void require_points(const PointList& list, size_t least, const char* what) {
  if (list.points.size() < least)
    fail(Status::kInsufficientData, "%zu points; %s needs %zu", list.points.size(), what, least);
}

[[noreturn]] void refuse(const PointList& list, const char* what, const PrimitiveSetting& setting) {
  fail(Status::kDegenerate,
       "%zu points fix no %s with a radius of %s to %s m within %s m: they are flat or straight, "
       "of another shape, or the "
       "limits are too narrow",
       list.points.size(), what, text_of(setting.min_radius_m).c_str(),
       text_of(setting.max_radius_m).c_str(), text_of(setting.tolerance_m).c_str());
}

// Area and extents of what lies within the tolerance; outliers have no part in them.
void describe_members(const PointList& list, const PrimitiveSetting& setting, Segment& segment,
                      Task& task) {
  if (!setting.robust) return describe_curved(list.points, 0, segment, task);
  std::vector<Vec3> members;
  serial_for(task, list.points.size(), kPrimitiveFitsPointsPerChunk, [&](size_t begin, size_t end) {
    for (const Vec3& p : std::span(list.points).subspan(begin, end - begin))
      if (std::fabs(segment.distance(p)) <= setting.tolerance_m) members.push_back(p);
  });
  describe_curved(members, 0, segment, task);
}

uint64_t point_index(std::span<const uint64_t> indices, size_t i) {
  return indices.empty() ? i : indices[i];
}

double occupied_area(std::span<const Vec2> uv, double pixel_m, Task& task) {
  const Raster raster = bounded_raster(uv, pixel_m, 0, task);
  const auto pixels = std::count(raster.pixels.begin(), raster.pixels.end(), uint8_t{1});
  return static_cast<double>(pixels) * raster.pixel_m * raster.pixel_m;
}

constexpr auto kPrimitiveFit = setting_rows(
    number_row<&PrimitiveSetting::tolerance_m>(
        "tolerance_m", 1e-6, 10, "m", "",
        "Largest distance of a point from the surface: a half-thickness; what lies beyond is "
        "an outlier."),
    number_row<&PrimitiveSetting::min_radius_m>("min_radius_m", 1e-6, 1e6, "m", "",
                                                "Smallest radius."),
    number_row<&PrimitiveSetting::max_radius_m>("max_radius_m", 1e-6, 1e6, "m", "",
                                                "Largest radius."),
    bool_row<&PrimitiveSetting::robust>(
        "robust", "",
        "Random draws, then weights that leave outliers out; off: least squares on every "
        "point given."));
constexpr auto kPrimitiveSeed = setting_rows(integer_row<&PrimitiveSetting::seed>(
    "seed", 0, 9e15, "1", "", "Seed of the random draws: the same seed gives the same result."));
constexpr auto kPrimitiveRows = setting_rows(
    nested_rows<&PrimitiveFitSettings::fit, kPrimitiveFit>(),
    integer_row<&PrimitiveFitSettings::k>(
        "k", 3, 256, "points", "",
        "Neighbours for the normals of a cylinder's points, where the cloud has no field "
        "\"normal\"."),
    nested_rows<&PrimitiveFitSettings::fit, kPrimitiveSeed>());

}  // namespace

PointList listed_points(const Cloud& cloud, std::span<const uint64_t> indices, Task& task) {
  const size_t n = indices.empty() ? cloud.size() : indices.size();
  for (const uint64_t i : indices)
    if (i >= cloud.size())
      fail(Status::kInvalidArgument, "point %llu; the cloud has %zu",
           static_cast<unsigned long long>(i), cloud.size());
  PointList out;
  if (n == 0) return out;
  const Vec3 first = cloud.point(point_index(indices, 0));
  out.origin = {std::floor(first.x), std::floor(first.y), std::floor(first.z)};
  out.points.resize(n);
  parallel_for(task, n, kPrimitiveFitsPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      out.points[i] = cloud.point(point_index(indices, i)) - out.origin;
  });
  return out;
}

Vec3 normal_near(const Cloud& cloud, const Octree& tree, const Vec3& place, uint32_t k) {
  std::vector<Neighbour> near(k);
  near.resize(tree.knn(place, k, near));
  Moments moments;
  moments.reference = place;
  for (const Neighbour& neighbour : near) moments.add(cloud.point(neighbour.index));
  PlaneFit fit;
  if (near.size() < 3 || !fit_plane(moments, fit)) return Vec3{kNaN, kNaN, kNaN};
  return fit.plane.normal;
}

std::vector<Vec3> listed_normals(const Cloud& cloud, std::span<const uint64_t> indices, uint32_t k,
                                 Task& task) {
  const size_t n = indices.empty() ? cloud.size() : indices.size();
  std::vector<Vec3> out(n);
  const Column* field = cloud.fields.find("normal");
  if (field != nullptr && field->info().components == 3 && is_floating(field->info().type)) {
    for (size_t i = 0; i < n; ++i) {
      const uint64_t p = point_index(indices, i);
      out[i] = normalized({field->number(p, 0), field->number(p, 1), field->number(p, 2)});
    }
    return out;
  }
  const auto tree = cloud.octree(task);
  parallel_for(task, n, kNormalsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      out[i] = normal_near(cloud, *tree, cloud.point(point_index(indices, i)), k);
  });
  return out;
}

std::span<const ParamRow> primitive_rows() { return kPrimitiveRows; }

void describe_curved(std::span<const Vec3> points, double pixel_m, Segment& segment, Task& task) {
  const SurfaceMap map = SurfaceMap::of(segment, points, task);
  std::vector<Vec2> uv(points.size());
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  serial_for(task, uv.size(), kPrimitiveFitsPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      uv[i] = map(points[i]);
      low = {std::min(low.u, uv[i].u), std::min(low.v, uv[i].v)};
      high = {std::max(high.u, uv[i].u), std::max(high.v, uv[i].v)};
    }
  });
  const bool cylinder = segment.type == PrimitiveType::kCylinder;
  segment.length_u_m = cylinder ? high.v - low.v : kNaN;
  segment.length_v_m = cylinder ? high.u - low.u : kNaN;
  const double n = static_cast<double>(points.size());
  double area = (high.u - low.u) * (high.v - low.v);
  for (int round = 0; pixel_m <= 0 && round < kPixelRounds && area > 0; ++round)
    area = occupied_area(uv, std::sqrt(kPointsPerPixel * area / n), task);
  segment.area_m2 = pixel_m > 0 ? occupied_area(uv, pixel_m, task) : area;
}

void shift_origin(Segment& segment, const Vec3& origin) {
  if (segment.has_plane()) shift_origin(segment.fit, origin);
  segment.sphere.sphere.centre += origin;
  segment.cylinder.cylinder.point += origin;
}

Segment sphere_segment(const Cloud& cloud, std::span<const uint64_t> indices,
                       const PrimitiveFitSettings& settings, Task& task) {
  const PointList list = listed_points(cloud, indices, task);
  const PrimitiveSetting& setting = settings.fit;
  require_points(list, 4, "a sphere");
  Segment out;
  out.label = 1;
  out.type = PrimitiveType::kSphere;
  if (!fit_sphere(list.points, setting, task, out.sphere)) refuse(list, "sphere", setting);
  describe_members(list, setting, out, task);
  shift_origin(out, list.origin);
  return out;
}

Segment cylinder_segment(const Cloud& cloud, std::span<const uint64_t> indices,
                         const Vec3* direction, const PrimitiveFitSettings& settings, Task& task) {
  const PointList list = listed_points(cloud, indices, task);
  const PrimitiveSetting& setting = settings.fit;
  Segment out;
  out.label = 1;
  out.type = PrimitiveType::kCylinder;
  bool found = false;
  if (direction != nullptr) {
    if (!(squared_norm(*direction) > 0))
      fail(Status::kInvalidArgument, "the direction of the axis has no length");
    require_points(list, 3, "a cylinder of a given direction");
    found = fit_cylinder_along(normalized(*direction), list.points, setting, task, out.cylinder);
  } else {
    require_points(list, 5, "a cylinder");
    const auto normals = listed_normals(cloud, indices, settings.k, task);
    found = fit_cylinder(list.points, normals, setting, task, out.cylinder);
  }
  if (!found) refuse(list, "cylinder", setting);
  describe_members(list, setting, out, task);
  shift_origin(out, list.origin);
  return out;
}

FieldTable circle_table(const Cloud& cloud, std::span<const uint64_t> indices,
                        const PrimitiveFitSettings& settings, Task& task) {
  const PointList list = listed_points(cloud, indices, task);
  const PrimitiveSetting& setting = settings.fit;
  require_points(list, 3, "a circle");
  PlaneFit plane;
  CircleFit fit;
  Moments moments;
  moments.reference = list.points.front();
  serial_for(task, list.points.size(), kPrimitiveFitsPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) moments.add(list.points[i]);
  });
  if (!fit_plane(moments, plane)) refuse(list, "circle", setting);
  std::vector<Vec2> uv(list.points.size());
  parallel_for(task, uv.size(), kPrimitiveFitsPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = list.points[i] - plane.centroid;
      uv[i] = {dot(p, plane.axis_u), dot(p, plane.axis_v)};
    }
  });
  if (!fit_circle(uv, setting, task, fit)) refuse(list, "circle", setting);
  const Vec2 c = fit.circle.centre;
  const Vec3 centre = list.origin + plane.centroid + c.u * plane.axis_u + c.v * plane.axis_v;
  const Vec3 n = plane.plane.normal;
  std::array<double, 12> j{};  // of (x, y, z, radius) by (u, v, radius)
  for (size_t i = 0; i < 3; ++i) {
    j[3 * i] = plane.axis_u[static_cast<int>(i)];
    j[3 * i + 1] = plane.axis_v[static_cast<int>(i)];
  }
  j[11] = 1;
  const auto covariance = propagated<4, 3>(j, fit.covariance);
  const double centre_xyz[3] = {centre.x, centre.y, centre.z}, normal_xyz[3] = {n.x, n.y, n.z};
  const uint64_t inliers[1] = {fit.n};
  const double radius[1] = {fit.circle.radius}, sigma[1] = {fit.sigma};
  FieldTable table;
  table.set(make_column<double>({"centre", ElementType::kFloat64, 3, "m", "centre"}, centre_xyz));
  table.set(make_column<double>(
      {"normal", ElementType::kFloat64, 3, "", "of the plane of the circle"}, normal_xyz));
  table.set(make_column<double>({"radius", ElementType::kFloat64, 1, "m", "radius"}, radius));
  table.set(make_column<double>(
      {"sigma", ElementType::kFloat64, 1, "m", "standard deviation in the plane"}, sigma));
  table.set(make_column<uint64_t>(
      {"inliers", ElementType::kUint64, 1, "points", "points that carry it"}, inliers));
  table.set(make_column<double>(
      {"covariance", ElementType::kFloat64, 16, "", "of centre and radius, rank 3"}, covariance));
  return table;
}

}  // namespace jalon
