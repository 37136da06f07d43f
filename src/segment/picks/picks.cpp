// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/picks/picks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/text_number.h"
#include "cloud/operations.h"
#include "segment/picks/growth.h"
#include "segment/result/facade.h"
#include "segment/result/point_columns.h"

namespace jalon {

namespace {

constexpr size_t kPickedPointsPerChunk = 1 << 15;
constexpr double kMostlyHorizontal = 0.985;  // |nz| within 10 degrees of the vertical

// Toward the station that saw most of the points; without stations upward, or toward the middle of the cloud.
// The segment is relative to the origin.
void face_the_station(const Cloud& cloud, const Vec3& origin, std::span<const uint32_t> members,
                      Segment& segment, Task& task) {
  const Plane& plane = segment.fit.plane;
  int64_t votes = 0;
  for (const Station& station : cloud.stations) {
    if (!station.has_pose) continue;
    const auto first = std::lower_bound(members.begin(), members.end(), station.first);
    const auto end =
        std::lower_bound(members.begin(), members.end(), station.first + station.count);
    votes += (plane.distance(station.pose.translation() - origin) >= 0 ? 1 : -1) * (end - first);
  }
  bool away = votes < 0;
  if (votes == 0) {
    const Box3 box = bounds(cloud, task);
    away = std::fabs(plane.normal.z) > kMostlyHorizontal
               ? plane.normal.z < 0
               : plane.distance(0.5 * (box.min + box.max) - origin) < 0;
  }
  if (away) turn_over(segment.fit);
}

template <class T>
std::shared_ptr<Column> copy_of(const Column& column) {
  auto out = std::make_shared<Column>(column.info(), column.count());
  const auto from = column.values<T>();
  std::copy(from.begin(), from.end(), out->values<T>().begin());
  return out;
}

// The points' columns of before, with the new segment's points filled in; their distances come from the segment as it
// is relative to the origin, so that large coordinates lose nothing.
void add_members(const Segmentation& before, const Vec3& origin, const Picked& picked,
                 Segmentation& out, Task& task) {
  auto labels = copy_of<uint32_t>(*before.labels);
  auto residuals = copy_of<float>(*before.residuals);
  auto orientations = copy_of<uint8_t>(*before.orientations);
  const Segment& segment = out.segments.back();
  parallel_for(task, picked.members.size(), kPickedPointsPerChunk, [&](size_t begin, size_t end) {
    for (const uint32_t i : std::span(picked.members).subspan(begin, end - begin)) {
      labels->values<uint32_t>()[i] = segment.label;
      residuals->values<float>()[i] =
          static_cast<float>(picked.segment.distance(out.cloud->point(i) - origin));
      orientations->values<uint8_t>()[i] = static_cast<uint8_t>(segment.orientation);
    }
  });
  out.labels = labels;
  out.residuals = residuals;
  out.orientations = orientations;
}

// Orientation of the new plane; when it is the new main facade, of all planes and of the frame.
void orient(const Segmentation& before, const PickSettings& settings, Segmentation& out) {
  const FacadeContext context{*out.cloud, {}, settings.orientation_tolerance_rad, true};
  std::vector<Segment> classed = out.segments;
  classify(context, classed);
  if (main_facade(out.segments) == main_facade(before.segments)) {
    if (out.segments.back().is_plane())
      out.segments.back().orientation = classed.back().orientation;
    return;
  }
  out.segments = std::move(classed);
  out.T_facade_world = facade_transform(context, out.segments);
}

// Origins: Boulaassal 2010, 5.5.2.2 (tolerances of 0.5 to 4 cm), 3.4.5.2 (1 degree).
constexpr auto kPickTolerance = setting_rows(number_row<&PrimitiveSetting::tolerance_m>(
    "tolerance_m", 1e-6, 10, "m", "",
    "Largest distance of a point from the surface: a half-thickness; 0.015 keeps sills "
    "and frames, 0.04 smooths."));
constexpr auto kPickRadii = setting_rows(
    number_row<&PrimitiveSetting::min_radius_m>("min_radius_m", 1e-6, 1e6, "m", "",
                                                "Smallest radius of a sphere or cylinder."),
    number_row<&PrimitiveSetting::max_radius_m>("max_radius_m", 1e-6, 1e6, "m", "",
                                                "Largest radius of a sphere or cylinder."));
constexpr auto kPickRows = setting_rows(
    nested_rows<&PickSettings::primitive, kPickTolerance>(),
    number_row<&PickSettings::min_area_m2>(
        "min_area_m2", 0, 1e9, "m2", "",
        "Smallest connected piece that belongs to the segment, the smallest detail that means "
        "something."),
    integer_row<&PickSettings::min_points>("min_points", 3, 4e9, "points", "",
                                           "Fewest points of a segment."),
    number_row<&PickSettings::gap_m>(
        "gap_m", 0, 100, "m", "",
        "Widest gap over which a segment grows from a seed or around its picks."),
    number_row<&PickSettings::pixel_m>(
        "pixel_m", 0, 100, "m", "",
        "Edge of a raster pixel for connectivity and area; 0 = twice the point spacing around "
        "the picks."),
    nested_rows<&PickSettings::primitive, kPickRadii>(),
    integer_row<&PickSettings::k>("k", 3, 256, "points", "",
                                  "Neighbours that give a seed its plane and a pick its normal."),
    number_row<&PickSettings::orientation_tolerance_rad>(
        "orientation_tolerance_rad", 1e-4, 0.785398, "rad", "",
        "Largest angle to the facade's axes for the orientation classes; 0.0175 = 1 degree."));

}  // namespace

std::span<const ParamRow> pick_rows() { return kPickRows; }

Segmentation empty_segmentation(const CloudPtr& cloud, Task& task) {
  Segmentation out;
  out.cloud = cloud;
  auto labels = make_label_column(cloud->size());
  std::fill(labels->values<uint32_t>().begin(), labels->values<uint32_t>().end(), 0u);
  out.labels = labels;
  out.parameters_json = "{\"method\":\"picks\"}";
  add_point_columns(out, {}, task);
  return out;
}

Segmentation with_pick(const Segmentation& before, PrimitiveType type, std::span<const Vec3> picks,
                       const PickSettings& settings, Task& task) {
  if (picks.empty()) fail(Status::kInsufficientData, "no picks");
  const Vec3 origin{std::floor(picks[0].x), std::floor(picks[0].y), std::floor(picks[0].z)};
  PickScene scene{*before.cloud, before.labels->values<uint32_t>(), origin, settings, {}};
  for (const Vec3& pick : picks) scene.picks.push_back(pick - origin);
  Picked picked = type == PrimitiveType::kPlane    ? pick_plane(scene, task)
                  : type == PrimitiveType::kSphere ? pick_sphere(scene, task)
                                                   : pick_cylinder(scene, task);
  if (picked.segment.is_plane())
    face_the_station(*before.cloud, origin, picked.members, picked.segment, task);
  picked.segment.label = static_cast<uint32_t>(before.segments.size() + 1);
  Segmentation out = before;
  out.segments.push_back(picked.segment);
  shift_origin(out.segments.back(), origin);
  orient(before, settings, out);
  add_members(before, origin, picked, out, task);
  if (main_facade(out.segments) != main_facade(before.segments)) {
    auto orientations = copy_of<uint8_t>(*out.orientations);
    const auto labels = out.labels->values<uint32_t>();
    const auto values = orientations->values<uint8_t>();
    parallel_for(task, labels.size(), kPickedPointsPerChunk, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i)
        values[i] = labels[i] == 0 ? uint8_t{0}
                                   : static_cast<uint8_t>(out.segments[labels[i] - 1].orientation);
    });
    out.orientations = orientations;
  }
  return out;
}

Cloud remaining_points(const Segmentation& segmentation, Task& task) {
  const auto labels = segmentation.labels->values<uint32_t>();
  std::vector<uint8_t> taken(labels.size());
  for (size_t i = 0; i < taken.size(); ++i) taken[i] = labels[i] != 0;
  return select_mask(*segmentation.cloud, taken, 0, task);
}

std::string primitive_text(const Segmentation& segmentation) {
  std::string out;
  const auto add = [&](std::initializer_list<double> numbers) {
    for (const double number : numbers) out += " " + text_of(number);
    out += "\n";
  };
  for (const Segment& s : segmentation.segments) {
    out += std::to_string(static_cast<int>(s.type));
    const Vec3 &n = s.fit.plane.normal, &c = s.sphere.sphere.centre, &a = s.cylinder.cylinder.point,
               &d = s.cylinder.cylinder.direction;
    if (s.type == PrimitiveType::kSphere) add({c.x, c.y, c.z, s.sphere.sphere.radius});
    else if (s.type == PrimitiveType::kCylinder)
      add({a.x, a.y, a.z, d.x, d.y, d.z, s.cylinder.cylinder.radius});
    else add({n.x, n.y, n.z, s.fit.plane.offset});
  }
  return out;
}

}  // namespace jalon
