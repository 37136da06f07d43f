// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/facade_view.h"

#include <cmath>
#include <set>

#include "base/text_number.h"
#include "report/elevation/colours.h"
#include "report/elevation/face_rings.h"
#include "report/names/evidence_name.h"
#include "report/names/orientation_name.h"
#include "report/names/part_tree.h"
#include "report/pictures/deviation_colours.h"
#include "report/pictures/label_colours.h"
#include "report/viewer/channels.h"

namespace jalon {

namespace {

constexpr Rgb kOutline{0x2a, 0x2a, 0x2a};

// "1.203 m (sigma 2.1 mm)"
std::string measure(double value_m, double sigma_m) {
  std::string text = text_of(value_m, 3) + " m";
  if (std::isfinite(sigma_m)) text += " (\xCF\x83 " + text_of(1000 * sigma_m, 1) + " mm)";
  return text;
}

std::string text_of_segment(const Segment& s) {
  const char* kind = s.is_plane()                       ? "plane "
                     : s.type == PrimitiveType::kSphere ? "sphere "
                                                        : "cylinder ";
  std::string text = kind + std::to_string(s.label);
  if (s.is_plane()) text += std::string(", ") + orientation_name(s.orientation);
  if (s.type == PrimitiveType::kSphere)
    text += ", radius " + text_of(s.sphere.sphere.radius, 3) + " m";
  else text += ", " + text_of(s.length_u_m, 2) + " x " + text_of(s.length_v_m, 2) + " m";
  return text + ", " + text_of(s.area_m2, 2) + " m\xC2\xB2, \xCF\x83 " +
         text_of(1000 * s.sigma_m(), 2) + " mm, " + grouped(s.point_count()) + " points";
}

std::string text_of_opening(const OpeningRow& row, const OpeningType& type) {
  std::string text = type.tag + (row.name.empty() ? "" : " " + row.name);
  if (row.name.find(row.part_class) == std::string::npos) text += ", " + row.part_class;
  if (std::isfinite(row.class_confidence))
    text += " (confidence " + text_of(row.class_confidence, 2) + ")";
  text += ": width " + measure(row.width_m, row.sigma_width_m) + ", height " +
          measure(row.height_m, row.sigma_height_m);
  if (std::isfinite(row.depth_m)) text += ", depth " + measure(row.depth_m, row.sigma_depth_m);
  const std::string evidence = evidence_name(row.evidence);
  return evidence.empty() ? text : text + ", " + evidence;
}

std::vector<Vec3> ring_in_space(const Model& model, const Ring& ring, const PlaneFrame& frame) {
  std::vector<Vec3> out;
  for (const Vec2& p : ring_polygon(model, ring, frame)) out.push_back(frame.lift(p));
  return out;
}

Rgb rgb_of(std::string_view hex) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 32) - 'a' + 10; };
  const auto byte = [&](size_t i) {
    return static_cast<uint8_t>(16 * digit(hex[i]) + digit(hex[i + 1]));
  };
  return {byte(1), byte(3), byte(5)};
}

void add_faces(ViewScene& scene, const Model& model, Task& task) {
  for (size_t f = 0; f < model.faces.size(); ++f) {
    if (f % 256 == 0) task.checkpoint(0);
    const Face& face = model.faces[f];
    const PlaneFrame frame = frame_of(model, face);
    ViewPart part;
    part.text = model.parts.empty() ? "face" : part_label(model, face.part);
    if (face.id != 0) part.text += ", plane " + std::to_string(face.id);
    part.text += ", " + text_of(face.area_m2, 2) + " m\xC2\xB2";
    if (face.sigma_m > 0) part.text += ", \xCF\x83 " + text_of(1000 * face.sigma_m, 2) + " mm";
    part.colour = kOutline;
    for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r)
      if (model.rings[r].count >= 3)
        part.rings.push_back(ring_in_space(model, model.rings[r], frame));
    if (!part.rings.empty()) scene.parts.push_back(std::move(part));
  }
}

// Behind the faces, whose holes they are: drawn over them, and found first by a click.
void add_openings_of(ViewScene& scene, const Model& model, const OpeningList& openings) {
  for (const OpeningRow& row : openings.rows) {
    const OpeningType& type = openings.types[row.type];
    for (const FaceRing& at : row.contour) {
      if (model.rings[at.ring].count < 3) continue;
      ViewPart part;
      part.tag = &at == row.contour.data() ? type.tag : "";
      part.text = text_of_opening(row, type);
      part.colour = rgb_of(opening_colour(row.part_class));
      part.is_opening = true;
      part.rings = {
          ring_in_space(model, model.rings[at.ring], frame_of(model, model.faces[at.face]))};
      scene.parts.push_back(std::move(part));
    }
  }
}

ViewChannel label_channel(const Segmentation& segmentation, const LabelRaster& front) {
  ViewChannel channel;
  channel.kind = ViewChannel::Kind::kLabel;
  channel.name = "segments";
  channel.colours = {kNoiseColour};
  for (const uint8_t colour : colour_labels(front, segmentation.segments.size()))
    channel.colours.push_back(segment_palette()[colour]);
  channel.value = [labels = segmentation.labels](size_t i) { return labels->number(i); };
  return channel;
}

ViewChannel residual_channel(const Segmentation& segmentation, double half_range_m) {
  ViewChannel channel;
  channel.name = "residual";
  channel.unit = "m";
  const DeviationScale scale{half_range_m, true};
  channel.low = -half_range_m;
  channel.high = half_range_m;
  for (uint32_t step = 0; step < DeviationScale::kSteps; ++step)
    channel.colours.push_back(scale.colour(step));
  channel.none = {{kNotComparedColour, "of no segment"}};
  channel.value = [residuals = segmentation.residuals](size_t i) { return residuals->number(i); };
  return channel;
}

}  // namespace

ViewScene facade_scene(const Segmentation& segmentation, const Model& model,
                       const OpeningList& openings, double half_range_m, Task& task) {
  return facade_scene(segmentation, model, openings, half_range_m,
                      rasterise_labels(segmentation, PictureView::kFront, task), task);
}

ViewScene facade_scene(const Segmentation& segmentation, const Model& model,
                       const OpeningList& openings, double half_range_m, const LabelRaster& front,
                       Task& task) {
  ViewScene scene;
  const auto& m = segmentation.T_facade_world.m;
  scene.along = {m[0], m[1], m[2]};
  scene.towards = {-m[4], -m[5], -m[6]};
  scene.labels = {"point of no segment"};
  for (const Segment& segment : segmentation.segments)
    scene.labels.push_back(text_of_segment(segment));
  ViewCloud view;
  view.name = "scan";
  view.cloud = segmentation.cloud;
  view.channels.push_back(label_channel(segmentation, front));
  view.channels.push_back(residual_channel(segmentation, half_range_m));
  add_field_channels(view);
  scene.clouds.push_back(std::move(view));
  add_faces(scene, model, task);
  add_openings_of(scene, model, openings);
  scene.focus = box_without_strays(*segmentation.cloud, {});
  if (!model.vertices.empty() && !model.faces.empty()) {
    scene.focus = {};
    for (const Vec3& p : model.vertices) scene.focus.add(p);
  }
  return scene;
}

}  // namespace jalon
