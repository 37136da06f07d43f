// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/comparison_view.h"

#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "base/text_number.h"
#include "report/viewer/channels.h"

namespace jalon {

namespace {

constexpr size_t kMostRegions = 400;  // as tags: more would cover what they name

ViewCloud cloud_of(const char* name, const Comparison& comparison, const DeviationScale& scale) {
  ViewCloud view;
  view.name = name;
  view.cloud = comparison.cloud;
  ViewChannel channel;
  channel.name = "distance";
  channel.unit = "m";
  channel.low = scale.lowest_m();
  channel.high = scale.limit_m;
  for (uint32_t step = 0; step < DeviationScale::kSteps; ++step)
    channel.colours.push_back(scale.colour(step));
  channel.none = {{kNotComparedColour, "no distance"}, {kHiddenColour, "hidden"}};
  const auto distance = comparison.points.find_shared("distance");
  const auto status = comparison.points.find_shared("status");
  channel.value = [distance, status](size_t i) {
    const bool hidden = status != nullptr &&
                        static_cast<CompareStatus>(status->number(i)) == CompareStatus::kHidden;
    return hidden ? -std::numeric_limits<double>::infinity() : distance->number(i);
  };
  view.channels.push_back(std::move(channel));
  add_field_channels(view);
  return view;
}

// A cross about each centroid of the table, with the row's number.
void add_centroids(ViewScene& scene, const FieldTable& changes, const char* column,
                   const char* what) {
  const Column* centroids = changes.find(column);
  if (centroids == nullptr || centroids->info().components != 3) return;
  for (size_t i = 0; i < std::min(centroids->count(), kMostRegions); ++i) {
    const Vec3 p{centroids->number(i, 0), centroids->number(i, 1), centroids->number(i, 2)};
    if (!std::isfinite(p.x + p.y + p.z)) continue;
    ViewPart part;
    part.tag = std::to_string(i + 1);
    part.text = std::string(what) + part.tag;
    if (const Column* volume = changes.find("volume"))
      part.text += ", volume " + text_of(volume->number(i), 3) + " m\xC2\xB3";
    part.colour = {0xe0, 0x00, 0x7a};
    constexpr double kArm_m = 0.05;
    part.rings = {{p - Vec3{kArm_m, 0, 0}, p + Vec3{kArm_m, 0, 0}},
                  {p - Vec3{0, kArm_m, 0}, p + Vec3{0, kArm_m, 0}},
                  {p - Vec3{0, 0, kArm_m}, p + Vec3{0, 0, kArm_m}}};
    scene.parts.push_back(std::move(part));
  }
}

}  // namespace

ViewScene comparison_scene(const Comparison& forward, const Comparison* reverse,
                           const FieldTable& changes, const DeviationScale& scale) {
  ViewScene scene;
  scene.clouds.push_back(cloud_of("compared", forward, scale));
  scene.focus = box_without_strays(*forward.cloud, {});
  if (reverse != nullptr) {
    scene.clouds.push_back(cloud_of("reference", *reverse, scale));
    scene.clouds.back().is_hidden = true;
    scene.clouds.back().colour = {0x2c, 0x72, 0x8e};
  }
  scene.clouds[0].colour = {0xc9, 0x6a, 0x12};
  add_centroids(scene, changes, "centroid", "region ");
  add_centroids(scene, changes, "centroid_after", "change ");
  return scene;
}

}  // namespace jalon
