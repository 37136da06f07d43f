// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/adjustment_view.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/text_number.h"
#include "model/trajectory/corrections.h"
#include "registration/joint/adjusted.h"
#include "registration/joint/strip_scene.h"
#include "report/pictures/deviation_colours.h"
#include "report/sheet/ticks.h"
#include "report/viewer/channels.h"

namespace jalon {

namespace {

constexpr double kShareOfDistances = 0.98;  // within the scale, as in the picture of a comparison

CloudPtr cloud_of(const std::vector<Vec3>& points) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = points[i][k];
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

ViewChannel distance_channel(const JointAdjustment& a) {
  std::vector<double> sizes;
  for (const PointMatch& match : a.matches)
    if (match.state == MatchState::kMatched) sizes.push_back(std::fabs(match.distance_m));
  std::sort(sizes.begin(), sizes.end());
  constexpr double kLeast_m = 1e-3;
  const double limit =
      sizes.empty()
          ? 1
          : round_up_125(std::max(
                kLeast_m, sizes[static_cast<size_t>(kShareOfDistances *
                                                    static_cast<double>(sizes.size() - 1))]));
  const DeviationScale scale{limit, true};
  ViewChannel channel;
  channel.name = "distance";
  channel.unit = "m";
  channel.low = -limit;
  channel.high = limit;
  for (uint32_t step = 0; step < DeviationScale::kSteps; ++step)
    channel.colours.push_back(scale.colour(step));
  channel.none = {{kNotComparedColour, "not matched"}};
  channel.value = [&matches = a.matches](size_t i) {
    return matches[i].state == MatchState::kMatched ? matches[i].distance_m : std::nan("");
  };
  return channel;
}

void add_strips_to(ViewScene& out, const JointAdjustment& a, const Model& model) {
  const StripScene scene = strip_scene(model, false);
  for (size_t f = 0; f < std::min(model.faces.size(), scene.strip_of_face.size()); ++f) {
    const uint32_t strip = scene.strip_of_face[f];
    const Face& face = model.faces[f];
    if (strip >= scene.strips.size() || face.ring_count == 0) continue;
    const double shift = shift_of(scene.strips[strip], strip, a.model);
    const Vec2 normal = scene.strips[strip].normal;
    const Vec3 by{normal.u * shift, normal.v * shift, 0};
    ViewPart part;
    part.text = "strip " + std::to_string(strip) + ", moved by " + text_of(1000 * shift, 1) + " mm";
    if (strip < a.strip_points.size())
      part.text += ", " + grouped(a.strip_points[strip]) + " points";
    if (strip < a.strip_sigmas.size() && std::isfinite(a.strip_sigmas[strip]))
      part.text += ", \xCF\x83 " + text_of(1000 * a.strip_sigmas[strip], 1) + " mm";
    const bool is_seen = strip < a.strip_points.size() && a.strip_points[strip] > 0;
    part.colour =
        is_seen ? Rgb{0x2a, 0x2a, 0x2a} : Rgb{0xc8, 0xc8, 0xc8};  // those of no point stand back
    const Ring& ring = model.rings[face.first_ring];
    part.rings.emplace_back();
    for (uint64_t c = 0; c < ring.count; ++c)
      part.rings[0].push_back(model.vertices[model.corners[ring.first + c]] + by);
    if (ring.count >= 3) out.parts.push_back(std::move(part));
  }
}

// There and back, for outlines are closed.
void add_drive_to(ViewScene& out, const Trajectory& drive, const char* name, const Rgb& colour) {
  ViewPart part;
  part.text = name;
  part.colour = colour;
  std::vector<Vec3> line = drive.positions;
  for (size_t i = drive.positions.size(); i-- > 0;) line.push_back(drive.positions[i]);
  part.rings.push_back(std::move(line));
  out.parts.push_back(std::move(part));
}

}  // namespace

ViewScene adjustment_scene(const JointAdjustment& adjustment, const AdjustedInputs& inputs) {
  ViewScene scene;
  scene.clouds.push_back(
      {"adjusted", cloud_of(adjusted_points(adjustment)), {}, {0x2f, 0x8a, 0x4c}, false, {}});
  scene.clouds.push_back(
      {"as given", cloud_of(adjustment.points.at), {}, {0xb3, 0x47, 0x2f}, true, {}});
  scene.clouds[0].channels.push_back(distance_channel(adjustment));
  scene.focus = box_without_strays(*scene.clouds[0].cloud, {});
  add_strips_to(scene, adjustment, inputs.model);
  add_drive_to(scene, inputs.trajectory, "the drive as given", {0xc0, 0x20, 0x20});
  add_drive_to(scene, adjusted_trajectory(adjustment, inputs.trajectory), "the drive adjusted",
               {0x1a, 0x80, 0x30});
  return scene;
}

}  // namespace jalon
