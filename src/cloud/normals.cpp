// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "base/memory_budget.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "cloud/normals_parts.h"
#include "cloud/normals_pca.h"
#include "cloud/operations.h"
#include "cloud/statistics.h"

namespace jalon {

namespace {

using Orientation = NormalsSettings::Orientation;

constexpr size_t kNormalsGrain = 1 << 15;

const Column& require_normals(const Cloud& cloud) {
  const Column& normal = cloud.fields.require("normal");
  if (normal.info().components != 3 || !is_floating(normal.info().type))
    fail(Status::kInvalidArgument,
         "field \"normal\" does not hold three floating-point numbers a point");
  return normal;
}

/// Turns n to the side of d (side +1) or away from it (-1).
void face(const Vec3& d, double side, float* n) {
  if (side * (d.x * double{n[0]} + d.y * double{n[1]} + d.z * double{n[2]}) < 0)
    for (int c = 0; c < 3; ++c) n[c] = -n[c];
}

void require_station_poses(const Cloud& cloud) {
  uint64_t covered = 0;
  for (const Station& station : cloud.stations) {
    if (station.count == 0) continue;
    if (station.first > covered || !station.has_pose) break;
    covered = station.first + station.count;
  }
  if (covered < cloud.size())
    fail(Status::kInvalidArgument,
         "orientation = station: point %llu has no station with a known pose; set one, or orient "
         "to a point",
         static_cast<unsigned long long>(covered));
}

}  // namespace

std::span<const ParamRow> normals_rows() {
  using S = NormalsSettings;
  static constexpr auto kRows = setting_rows(
      choice_row<&S::method>(
          "method", "pca|quadric|triangulation", "",
          "pca: plane through the neighbours; quadric: curved surface through "
          "them; triangulation: of the points of an octree cell, rougher than pca and "
          "no faster"),
      integer_row<&S::k>("k", 3, 256, "points", "pca,quadric",
                         "Number of nearest neighbours, the point itself included; not read when "
                         "radius_m is above 0"),
      number_row<&S::radius_m>("radius_m", 0, 1e6, "m", "pca,quadric",
                               "Radius of the ball of neighbours; 0 = take the k nearest instead"),
      bool_row<&S::curvature>(
          "curvature", "pca",
          "Also keep the surface variation of each neighbourhood, as field \"curvature\""),
      choice_row<&S::orientation>("orientation", "none|station|point|centroid", "",
                                  "Turn normals toward each point's scan station, toward "
                                  "viewpoint, or away from the centroid"),
      doubles_row<&S::viewpoint>("viewpoint", -1e9, 1e9, "m", "",
                                 "The point (x, y, z) that orientation = point turns normals to"),
      bool_row<&S::outward>("outward", "",
                            "For orientation = centroid: true turns normals away from the "
                            "centroid, false toward it"));
  return kRows;
}

void require_orientation(const Cloud& cloud, const NormalsSettings& settings) {
  if (settings.orientation == Orientation::kStation) require_station_poses(cloud);
  if (const size_t n = settings.viewpoint.size();
      settings.orientation == Orientation::kPoint && n != 3)
    fail(Status::kInvalidArgument, "viewpoint has %zu numbers; it needs x, y, z", n);
}

void orient(const Cloud& cloud, const NormalsSettings& settings, Column& normal, Task& task) {
  const Orientation orientation = settings.orientation;
  if (orientation == Orientation::kNone || cloud.size() == 0) return;
  Vec3 origin, target;
  double side = 1;
  if (orientation == Orientation::kPoint) {
    target = {settings.viewpoint[0], settings.viewpoint[1], settings.viewpoint[2]};
  } else if (orientation == Orientation::kCentroid) {
    const CloudCovariance whole = covariance_of(cloud, task);
    origin = whole.origin;
    target = whole.local_centroid;
    side = settings.outward ? -1 : 1;
  }
  const bool by_station = orientation == Orientation::kStation;
  const auto normals = normal.values<float>();
  parallel_for(task, cloud.size(), kNormalsGrain, [&](size_t begin, size_t end) {
    const Station* station = nullptr;
    for (size_t i = begin; i < end; ++i) {
      if (by_station && (station == nullptr || i - station->first >= station->count))
        station = station_of(cloud, i);
      const Vec3 seen_from = by_station ? station->pose.translation() : target;
      face(seen_from - (cloud.point(i) - origin), side, normals.data() + 3 * i);
    }
  });
}

Cloud with_normals(const Cloud& cloud, const NormalsSettings& settings, Task& task) {
  using Method = NormalsSettings::Method;
  require_orientation(cloud, settings);
  Cloud out = cloud;
  std::shared_ptr<const Octree> tree;
  {
    ProgressSpan span(task, 0, 0.2, "index");
    tree = cloud.octree(task);
  }
  PcaNormals normals;
  {
    ProgressSpan span(task, 0.2, 0.95, "normals");
    if (settings.method == Method::kQuadric)
      normals.normal = quadric_normals(*tree, settings.k, settings.radius_m, task);
    else if (settings.method == Method::kTriangulation)
      normals.normal = triangulation_normals(*tree, task);
    else
      normals = settings.radius_m > 0
                    ? pca_normals_radius(*tree, settings.radius_m, settings.curvature, task)
                    : pca_normals(*tree, settings.k, settings.curvature, task);
  }
  ProgressSpan span(task, 0.95, 1, "orientation");
  orient(cloud, settings, *normals.normal, task);
  out.fields.set(std::move(normals.normal));
  if (normals.curvature) out.fields.set(std::move(normals.curvature));
  return out;
}

Cloud with_inverted_normals(const Cloud& cloud, Task& task) {
  const Column& normal = require_normals(cloud);
  require_memory(normal.bytes());
  auto inverted = std::make_shared<Column>(normal.info(), normal.count());
  visit(normal.info().type, [&](auto zero) {
    using T = decltype(zero);
    if constexpr (std::is_floating_point_v<T>) {
      const auto from = normal.values<T>();
      const auto to = inverted->template values<T>();
      parallel_for(task, from.size(), 3 * kNormalsGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) to[i] = -from[i];
      });
    }
  });
  Cloud out = cloud;
  out.fields.set(std::move(inverted));
  return out;
}

}  // namespace jalon
