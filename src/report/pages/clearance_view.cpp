// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/clearance_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <unordered_map>

#include "base/text_number.h"
#include "report/pictures/deviation_colours.h"
#include "report/viewer/channels.h"

namespace jalon {

namespace {

// Red where it touches, over orange to yellow at the margin: told apart with red-green blindness by their lightness.
constexpr Rgb kInside{0x8e, 0x10, 0x1c}, kTouch{0xc0, 0x39, 0x2b}, kAtMargin{0xf6, 0xd2, 0x5a},
    kFree{0xb4, 0xb4, 0xb4};
constexpr int kClearanceSteps = 32;

// Clearance of each point of the cloud; NaN: beyond the margin.
std::vector<double> clearance_of_points(const FieldTable& places, size_t points) {
  std::vector<double> out(points, std::numeric_limits<double>::quiet_NaN());
  const std::span<const uint64_t> row = places.require("point").values<uint64_t>();
  const std::span<const double> clearance = places.require("clearance").values<double>();
  for (size_t i = 0; i < row.size(); ++i)
    if (row[i] < points) out[row[i]] = clearance[i];
  return out;
}

// Of each point on a model the least clearance of its face or triangle.
std::vector<double> clearance_of_faces(const FieldTable& places, const Cloud& on_model) {
  std::unordered_map<uint64_t, double> of_face, of_triangle;
  const std::span<const uint64_t> face = places.require("face").values<uint64_t>(),
                                  triangle = places.require("triangle").values<uint64_t>();
  const std::span<const double> clearance = places.require("clearance").values<double>();
  const auto lower = [](std::unordered_map<uint64_t, double>& least, uint64_t row, double value) {
    const auto [at, is_new] = least.emplace(row, value);
    if (!is_new) at->second = std::min(at->second, value);
  };
  for (size_t i = 0; i < clearance.size(); ++i) {
    lower(of_face, face[i], clearance[i]);
    lower(of_triangle, triangle[i], clearance[i]);
  }
  constexpr uint32_t kNone = ~uint32_t{0};
  const std::span<const uint32_t> on_face = on_model.fields.require("face").values<uint32_t>(),
                                  on_triangle =
                                      on_model.fields.require("triangle").values<uint32_t>();
  std::vector<double> out(on_model.size(), std::numeric_limits<double>::quiet_NaN());
  for (size_t i = 0; i < out.size(); ++i) {
    const auto& least = on_face[i] != kNone ? of_face : of_triangle;
    const auto at = least.find(on_face[i] != kNone ? on_face[i] : on_triangle[i]);
    if (at != least.end()) out[i] = at->second;
  }
  return out;
}

// Of all that is shown: one scale.
double least_clearance(const FieldTable& places) {
  double low = 0;
  for (const double value : places.require("clearance").values<double>())
    if (std::isfinite(value)) low = std::min(low, value);
  return low;
}

ViewChannel clearance_channel(const std::shared_ptr<const std::vector<double>>& values,
                              double low_m, double margin_m) {
  ViewChannel channel;
  channel.name = "clearance";
  channel.unit = "m";
  channel.low = low_m;
  channel.high = margin_m > channel.low ? margin_m : channel.low + 1e-3;
  for (int step = 0; step < kClearanceSteps; ++step) {
    const double value = channel.low + (channel.high - channel.low) * step / (kClearanceSteps - 1);
    channel.colours.push_back(value < 0 ? mixed(kTouch, kInside, value / channel.low)
                                        : mixed(kTouch, kAtMargin, value / channel.high));
  }
  channel.none = {{kFree, "beyond the margin"}, {kFree, ""}};
  channel.value = [values](size_t i) { return (*values)[i]; };
  return channel;
}

ViewPart cross_at(const TightPlace& place, size_t number) {
  constexpr double kArm_m = 0.1;
  const Vec3 p = place.obstacle;
  ViewPart part;
  part.tag = std::to_string(number);
  part.text = "place " + part.tag + ", clearance " + text_of(place.clearance_m, 3) + " m";
  part.colour = {0xe0, 0x00, 0x7a};
  part.rings = {{p - Vec3{kArm_m, 0, 0}, p + Vec3{kArm_m, 0, 0}},
                {p - Vec3{0, kArm_m, 0}, p + Vec3{0, kArm_m, 0}},
                {p - Vec3{0, 0, kArm_m}, p + Vec3{0, 0, kArm_m}}};
  return part;
}

// There and back: rings are closed, and a way is not.
ViewPart way_of(const GaugePath& path) {
  constexpr size_t kMostCorners = 2000;
  ViewPart part;
  part.text = "way of the gauge's origin, " + text_of(path.length_m(), 2) + " m";
  part.colour = {0x2c, 0x72, 0x8e};
  const size_t n = path.poses().size(), stride = std::max<size_t>(1, n / kMostCorners);
  std::vector<Vec3> way;
  for (size_t i = 0; i < n; i += stride) way.push_back(path.poses()[i].translation());
  way.push_back(path.poses().back().translation());
  way.insert(way.end(), way.rbegin() + 1, way.rend());
  part.rings = {std::move(way)};
  return part;
}

}  // namespace

ViewScene clearance_scene(const CloudPtr& cloud, const CloudPtr& on_model, const FieldTable& places,
                          const GaugePath& path, std::span<const TightPlace> tight,
                          double margin_m) {
  ViewScene scene;
  const auto add = [&](const char* name, const CloudPtr& points, std::vector<double> clearance) {
    ViewCloud view;
    view.name = name;
    view.cloud = points;
    view.channels.push_back(
        clearance_channel(std::make_shared<const std::vector<double>>(std::move(clearance)),
                          least_clearance(places), margin_m));
    if (points == cloud) add_field_channels(view);
    scene.clouds.push_back(std::move(view));
    scene.focus += box_without_strays(*points, {});
  };
  if (cloud != nullptr && cloud->size() > 0)
    add("obstacles", cloud, clearance_of_points(places, cloud->size()));
  if (on_model != nullptr && on_model->size() > 0)
    add("points on the model", on_model, clearance_of_faces(places, *on_model));
  scene.parts.push_back(way_of(path));
  for (size_t i = 0; i < tight.size(); ++i) scene.parts.push_back(cross_at(tight[i], i + 1));
  return scene;
}

}  // namespace jalon
