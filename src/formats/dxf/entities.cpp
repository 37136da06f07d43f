// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/text_number.h"
#include "formats/dxf/sections.h"

namespace jalon::dxf {

namespace {

constexpr double kPlanar_m =
    1e-6;  // of corners from the plane of their ring, to be drawn as a planar polyline
constexpr int kClosed = 1, kPolyline3d = 8, kVertex3d = 32;

/// A polyline in its object coordinate system.
struct Planar {
  std::vector<Vec3> corners;  ///< z: the elevation of each
  double elevation_m = 0;
  double spread_m = 0;  ///< largest distance of a corner from that elevation
};

Planar planar(const Polyline& line, const ObjectAxes& axes) {
  Planar out;
  double sum = 0;
  for (const Vec3& p : line.corners) {
    out.corners.push_back(axes.project(p));
    sum += out.corners.back().z - out.corners.front().z;
  }
  out.elevation_m = out.corners.front().z + sum / static_cast<double>(line.corners.size());
  for (const Vec3& p : out.corners)
    out.spread_m = std::max(out.spread_m, std::fabs(p.z - out.elevation_m));
  return out;
}

// DXF Reference: the tangent of a quarter of the angle, negative when clockwise; 2 s / c by the
// sagitta s and the chord c.
double bulge(const Polyline& line, size_t i) {
  if (line.sagittas_m.empty()) return 0;
  const double chord_m = norm(line.corners[(i + 1) % line.corners.size()] - line.corners[i]);
  return chord_m > 0 ? 2 * (line.sagittas_m[i] / chord_m) : 0;
}

void begin_entity(Text& text, const char* name, const Layer& layer, uint64_t handle,
                  uint64_t owner = kModelSpace) {
  text.begin(name, handle, owner).subclass("AcDbEntity").group(8, layer.name);
}

// What it is, for programs that ask: application data that CAD systems carry along.
void add_data(Text& text, const Polyline& line, const Model& model) {
  if (!line.is_ring) return;
  text.group(1001, "JALON").group(1000, "face=" + std::to_string(line.face_id));
  if (line.part >= model.parts.size()) return;
  const Part& part = model.parts[line.part];
  text.group(1000, "part=" + part.name)
      .group(1000, "number=" + std::to_string(line.part))  // several facades have the same names
      .group(1000, "class=" + part.part_class);
  if (part.evidence != Evidence::kNone)
    text.group(1000, std::string("evidence=") + name_of(part.evidence));
  if (part.copied_from < model.parts.size())
    text.group(1000, "copied_from=" + model.parts[part.copied_from].name);
  if (std::isfinite(part.depth_m)) text.group(1000, "depth_m=" + text_of(part.depth_m));
  if (std::isfinite(part.class_confidence))
    text.group(1000, "class_confidence=" + text_of(part.class_confidence));
}

void add_lightweight(Text& text, const Polyline& line, const Planar& flat, const Layer& layer,
                     uint64_t handle) {
  begin_entity(text, "LWPOLYLINE", layer, handle);
  text.subclass("AcDbPolyline")
      .group(90, static_cast<int>(line.corners.size()))
      .group(70, line.is_closed ? kClosed : 0);
  text.group(43, 0.0).group(38, flat.elevation_m);
  for (size_t i = 0; i < line.corners.size(); ++i) {
    text.group(10, flat.corners[i].x).group(20, flat.corners[i].y);
    if (const double b = bulge(line, i); b != 0) text.group(42, b);
  }
  text.point(210, line.normal);
}

/// POLYLINE with its VERTEX entities and SEQEND: planar in the object coordinate system, or in space.
void add_heavy(Text& text, const Polyline& line, const Planar* flat, const Layer& layer,
               const Model& model, uint64_t& next_handle) {
  const uint64_t own = next_handle++;
  begin_entity(text, "POLYLINE", layer, own);
  text.subclass(flat != nullptr ? "AcDb2dPolyline" : "AcDb3dPolyline").group(66, 1);
  text.point(10, {0, 0, flat != nullptr ? flat->elevation_m : 0});
  text.group(70, (line.is_closed ? kClosed : 0) + (flat != nullptr ? 0 : kPolyline3d));
  if (flat != nullptr) text.point(210, line.normal);
  add_data(text, line, model);
  for (size_t i = 0; i < line.corners.size(); ++i) {
    begin_entity(text, "VERTEX", layer, next_handle++, own);
    text.subclass("AcDbVertex").subclass(flat != nullptr ? "AcDb2dVertex" : "AcDb3dPolylineVertex");
    if (flat == nullptr) {
      text.point(10, line.corners[i]).group(70, kVertex3d);
      continue;
    }
    text.point(10, {flat->corners[i].x, flat->corners[i].y, flat->elevation_m});
    if (const double b = bulge(line, i); b != 0) text.group(42, b);
  }
  begin_entity(text, "SEQEND", layer, next_handle++, own);
}

}  // namespace

ObjectAxes object_axes(const Vec3& normal) {
  constexpr double kNearZ = 1.0 / 64;  // of the algorithm
  const Vec3 z = normalized(normal);
  const Vec3 help =
      std::fabs(z.x) < kNearZ && std::fabs(z.y) < kNearZ ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 x = normalized(cross(help, z));
  return {x, normalized(cross(z, x)), z};
}

void add_polyline(Text& text, const Polyline& line, const Layer& layer, const Model& model,
                  uint64_t& next_handle) {
  const Planar flat = planar(line, object_axes(line.normal));
  const bool arcs = !line.sagittas_m.empty();
  // Straight rings of release 12 stand in space, where their coordinates are exactly the model's; so do rings that
  // bend out of their plane.
  if (!arcs && (text.is_r12() || flat.spread_m > kPlanar_m))
    return add_heavy(text, line, nullptr, layer, model, next_handle);
  if (text.is_r12()) return add_heavy(text, line, &flat, layer, model, next_handle);
  add_lightweight(text, line, flat, layer, next_handle++);
  add_data(text, line, model);
}

void add_label(Text& text, const Label& label, const Layer& layer, uint64_t& next_handle) {
  constexpr int kCentred = 1, kMiddle = 2;
  const Vec3 at = object_axes(label.normal).project(label.at);
  begin_entity(text, "TEXT", layer, next_handle++);
  text.subclass("AcDbText")
      .point(10, at)
      .group(40, label.height_m)
      .group(1, label.text)
      .group(72, kCentred);
  text.point(11, at).point(210, label.normal).subclass("AcDbText").group(73, kMiddle);
}

ImageHandles image_handles(const Drawing& drawing, size_t image) {
  const uint64_t first = kFirstFree + drawing.layers.all().size() + 3 * image;
  return {first, first + 1, first + 2};
}

void add_image(Text& text, const Drawing& drawing, size_t i) {
  constexpr int kShown = 1 + 2, kTransparent = 8, kRectangle = 1, kMiddleOfScale = 50;
  const LinkedImage& image = drawing.images[i];
  const ImageHandles handles = image_handles(drawing, i);
  begin_entity(text, "IMAGE", drawing.layers.all()[drawing.image_layer], handles.entity);
  text.subclass("AcDbRasterImage").group(90, 0);
  text.point(10, image.at).point(11, image.right).point(12, image.up);
  text.group(13, double(image.columns)).group(23, double(image.rows));
  text.handle(340, handles.definition).group(70, kShown + kTransparent).group(280, 0);
  text.group(281, kMiddleOfScale).group(282, kMiddleOfScale).group(283, 0);
  text.handle(360, handles.reactor).group(71, kRectangle).group(91, 2);
  // The whole picture: from half a pixel before the middle of the first to half a pixel behind that of the last.
  text.group(14, -0.5).group(24, -0.5);
  text.group(14, image.columns - 0.5).group(24, image.rows - 0.5);
}

void add_triangle(Text& text, const std::array<Vec3, 3>& corners, const Layer& layer,
                  uint64_t& next_handle) {
  begin_entity(text, "3DFACE", layer, next_handle++);
  text.subclass("AcDbFace");
  for (int k = 0; k < 4; ++k) text.point(10 + k, corners[static_cast<size_t>(std::min(k, 2))]);
}

}  // namespace jalon::dxf
