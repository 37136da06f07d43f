// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/clearance_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

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

ViewChannel clearance_channel(const std::shared_ptr<const std::vector<double>>& values,
                              double margin_m) {
  ViewChannel channel;
  channel.name = "clearance";
  channel.unit = "m";
  channel.low = 0;
  for (const double value : *values)
    if (std::isfinite(value)) channel.low = std::min(channel.low, value);
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

ViewScene clearance_scene(const CloudPtr& cloud, const FieldTable& places, const GaugePath& path,
                          std::span<const TightPlace> tight, double margin_m) {
  ViewScene scene;
  ViewCloud view;
  view.name = "obstacles";
  view.cloud = cloud;
  view.channels.push_back(clearance_channel(
      std::make_shared<const std::vector<double>>(clearance_of_points(places, cloud->size())),
      margin_m));
  add_field_channels(view);
  scene.clouds.push_back(std::move(view));
  scene.parts.push_back(way_of(path));
  for (size_t i = 0; i < tight.size(); ++i) scene.parts.push_back(cross_at(tight[i], i + 1));
  scene.focus = box_without_strays(*cloud, {});
  return scene;
}

}  // namespace jalon
