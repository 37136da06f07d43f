// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/dxf/drawing.h"

#include <algorithm>
#include <cmath>

#include "model/chords.h"
#include "model/opening_rings.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"

namespace jalon::dxf {

namespace {

constexpr size_t kMaxLayerName = 31;  // of release 12

struct ClassColour {
  const char* part_class;
  int colour;
};
constexpr ClassColour kColours[] = {
    {part_class::kWall, 7},         {part_class::kOpening, 4},     {part_class::kWindow, 5},
    {part_class::kDoor, 1},         {part_class::kReveal, 9},      {part_class::kJoinery, 140},
    {part_class::kSill, 30},        {part_class::kCornice, 6},     {part_class::kStringCourse, 200},
    {part_class::kBaseCourse, 34},  {part_class::kPost, 2},        {part_class::kGround, 3},
    {part_class::kRoof, 12},        {part_class::kElement, 40},    {part_class::kNoData, 8},
    {part_class::kRegion, 1},       {part_class::kAppearance, 3},  {part_class::kDisappearance, 1},
    {part_class::kDisplacement, 5}, {part_class::kDeformation, 6}, {part_class::kGateway, 10},
    {part_class::kShopFront, 130},  {part_class::kVent, 190},      {part_class::kRecess, 54},
    {part_class::kGutter, 240},     {part_class::kDepletion, 5},   {part_class::kAccumulation, 1},
    {part_class::kUnmeasured, 8},
};
constexpr int kOtherColour = 7;

// Of the class, and of "displacement_before" as of "displacement".
int colour_of(const std::string& part_class) {
  for (const ClassColour& row : kColours)
    if (part_class == row.part_class || part_class.starts_with(row.part_class + std::string("_")))
      return row.colour;
  return kOtherColour;
}

// Release 12 takes capitals, digits, $, - and _.
std::string layer_name(const std::string& part_class, bool copied) {
  const std::string suffix = copied ? "-COPIED" : "";
  std::string out;
  for (const char c : part_class.substr(0, kMaxLayerName - suffix.size())) {
    const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    const bool plain =
        (upper >= 'A' && upper <= 'Z') || (upper >= '0' && upper <= '9') || upper == '-';
    out += plain ? upper : '_';
  }
  return (out.empty() ? "ELEMENT" : out) + suffix;
}

// The class of a hole's part, or an opening of unknown kind; a hole without data behind it stays part of its wall.
uint32_t ring_layer(Layers& layers, const Model& model, const Face& face, uint64_t r) {
  if (r == face.first_ring) return layers.of_part(model, face.part);
  const uint32_t part = model.rings[r].part;
  return part < model.parts.size() ? layers.of_part(model, part)
                                   : layers.of_class(part_class::kOpening);
}

// The horizontal direction that most of the wall looks to; upward for models without upright faces.
Vec3 direction_of_view(const Model& model) {
  Vec3 sum;
  double largest = 0;
  for (const Face& face : model.faces) {
    const Vec3 normal = normal_of(model, face);
    if (std::fabs(normal.z) < 0.5 && face.area_m2 > largest) {
      largest = face.area_m2;
      sum = {normal.x, normal.y, 0};
    }
  }
  return largest > 0 ? normalized(sum) : Vec3{0, 0, 1};
}

// The number of a change region, which tables list it by, in the middle of its outline.
void add_number(Drawing& drawing, const Model& model, const Face& face, const Vec3& normal) {
  constexpr double kShare = 0.25;  // of the side of a square as large as the region
  const uint64_t parent =
      face.part < model.parts.size() ? model.parts[face.part].parent : kNoParent;
  if (parent >= model.parts.size() || model.parts[parent].part_class != part_class::kChanges)
    return;
  if (!(face.area_m2 > 0) || face.ring_count == 0 || squared_norm(normal) == 0) return;
  const Ring& ring = model.rings[face.first_ring];
  const Vec3 first = model.vertices[model.corners[ring.first]];
  Vec3 sum;
  for (uint64_t c = 0; c < ring.count; ++c)
    sum += model.vertices[model.corners[ring.first + c]] - first;
  const Vec3 middle = first + sum / static_cast<double>(ring.count);
  drawing.labels.push_back({middle, normal, kShare * std::sqrt(face.area_m2),
                            std::to_string(face.id), drawing.layers.of_part(model, face.part)});
}

void add_triangles(Drawing& drawing, const Model& model) {
  const bool by_part = is_mesh_by_part(model);
  for (const uint32_t t : loose_triangles(model)) {
    drawing.triangles.push_back(model.triangles[t]);
    drawing.triangle_layers.push_back(by_part
                                          ? drawing.layers.of_part(model, model.triangle_faces[t])
                                          : drawing.layers.of_class("mesh"));
    for (const uint32_t v : model.triangles[t]) drawing.box.add(model.vertices[v]);
  }
}

}  // namespace

uint32_t Layers::of_part(const Model& model, uint32_t part) {
  if (part >= model.parts.size()) return of_class(part_class::kElement);
  const Part& p = model.parts[part];
  return of_class(p.part_class, p.evidence == Evidence::kCopied);
}

uint32_t Layers::named(const std::string& name, int colour, DxfVersion version) {
  std::string safe = version == DxfVersion::kR12 ? layer_name(name, false) : name;
  std::replace(safe.begin(), safe.end(), ' ', '_');
  const auto [entry, added] = index_.try_emplace(safe, static_cast<uint32_t>(layers_.size()));
  if (added) layers_.push_back({safe, colour, false});
  return entry->second;
}

uint32_t Layers::of_class(const std::string& part_class, bool copied) {
  const std::string name = layer_name(part_class, copied);
  const auto [entry, added] = index_.try_emplace(name, static_cast<uint32_t>(layers_.size()));
  if (added)
    layers_.push_back({name, colour_of(part_class), copied || part_class == part_class::kNoData});
  return entry->second;
}

namespace {

// A ring without layer and part; no corners when it has no extent.
Polyline line_of(const Model& model, const Face& face, uint64_t r, const Vec3& normal) {
  const Ring& ring = model.rings[r];
  Polyline line;
  bool arcs = false;
  for (uint64_t c = ring.first; c < ring.first + ring.count; ++c) {
    const double sagitta_m = std::isfinite(model.sagitta(c)) ? model.sagitta(c) : 0;
    line.corners.push_back(model.vertices[model.corners[c]]);
    line.sagittas_m.push_back(sagitta_m);
    arcs = arcs || sagitta_m != 0;
  }
  if (line.corners.size() < (arcs ? 2 : 3) || squared_norm(normal) == 0) return {};
  if (!arcs) line.sagittas_m.clear();
  line.normal = normal;
  line.face_id = face.id;
  return line;
}

}  // namespace

void add_ring(Drawing& drawing, const Model& model, const Face& face, uint64_t r,
              const Vec3& normal) {
  Polyline line = line_of(model, face, r, normal);
  if (line.corners.empty()) return;
  line.layer = ring_layer(drawing.layers, model, face, r);
  line.part = r == face.first_ring ? face.part : model.rings[r].part;
  drawing.polylines.push_back(std::move(line));
}

void add_openings(Drawing& drawing, const Model& model, const Face& face, const Vec3& normal,
                  const std::vector<uint32_t>& openings) {
  for (const uint32_t part : openings) {
    Polyline line = line_of(model, face, face.first_ring, normal);
    if (line.corners.empty()) continue;
    line.layer = drawing.layers.of_part(model, part);
    line.part = part;
    drawing.polylines.push_back(std::move(line));
  }
}

std::vector<std::vector<uint32_t>> openings_shown_by(const Model& model) {
  std::vector<std::vector<uint32_t>> out(model.faces.size());
  const auto rings = opening_rings(model);
  for (uint32_t part = 0; part < rings.size(); ++part)
    if (!rings[part].empty() && !has_own_ring(model, part, rings[part]))
      out[rings[part].front().face].push_back(part);
  return out;
}

Drawing draw_world(const Model& model, Task& task) {
  constexpr size_t kTicks = 256;  // faces between two looks at the task
  Drawing drawing;
  const auto shown = openings_shown_by(model);
  for (size_t f = 0; f < model.faces.size(); ++f) {
    if (f % kTicks == 0)
      task.checkpoint(static_cast<double>(f) / static_cast<double>(model.faces.size()));
    const Face& face = model.faces[f];
    const Vec3 normal = normal_of(model, face);
    for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r)
      add_ring(drawing, model, face, r, normal);
    add_openings(drawing, model, face, normal, shown[f]);
    add_number(drawing, model, face, normal);
  }
  for (const Polyline& line : drawing.polylines)
    for (const Vec3& p : line.corners) drawing.box.add(p);
  drawing.view_direction = direction_of_view(model);
  add_triangles(drawing, model);
  return drawing;
}

}  // namespace jalon::dxf
