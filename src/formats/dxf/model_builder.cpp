// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/dxf/model_builder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "formats/files/utf8.h"
#include "geometry/polygon2.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"

namespace jalon::dxf {

namespace {

constexpr double kSliver =
    1e-12;  // area over the square of the extent: below it a loop bounds nothing
constexpr double kSamePlane = 1e-6;  // of unit normals of rings of one face
constexpr double kInPlane_m = 1e-5;  // of a hole's corner from the plane of its outline
constexpr std::string_view kCopied = "-copied";

// The words that layers of our own drawings have (drawing.cpp).
constexpr const char* kKnown[] = {
    part_class::kWall,    part_class::kWindow,       part_class::kDoor,
    part_class::kGateway, part_class::kShopFront,    part_class::kVent,
    part_class::kRecess,  part_class::kOpening,      part_class::kReveal,
    part_class::kJoinery, part_class::kSill,         part_class::kCornice,
    part_class::kPost,    part_class::kStringCourse, part_class::kBaseCourse,
    part_class::kRoof,    part_class::kGround,       part_class::kElement,
    part_class::kNoData};

std::string class_of_layer(const std::string& layer) {
  std::string word = lower(layer);
  if (word.ends_with(kCopied)) word.resize(word.size() - kCopied.size());
  const bool is_known =
      std::find(std::begin(kKnown), std::end(kKnown), std::string_view(word)) != std::end(kKnown);
  return is_known ? word : "";
}

// Twice the vector area of the chords, about the first corner.
Vec3 twice_area_of(const std::vector<Vec3>& corners) {
  Vec3 sum;
  for (size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return sum;
}

// Between an arc and its chord, positive where it lies outside of an anticlockwise loop: r2 (angle - sin angle) / 2.
double segment_area(double chord, double bulge) {
  if (bulge == 0) return 0;
  const double b = std::fabs(bulge), angle = 4 * std::atan(b),
               radius = chord * (1 + b * b) / (4 * b);
  return std::copysign(radius * radius * (angle - std::sin(angle)) / 2, bulge);
}

double area_of(const Loop& loop, const Vec3& normal) {
  double sum = dot(twice_area_of(loop.corners), normal) / 2;
  for (size_t i = 0; i < loop.corners.size(); ++i)
    sum += segment_area(norm(loop.corners[(i + 1) % loop.corners.size()] - loop.corners[i]),
                        loop.bulges[i]);
  return sum;
}

// The other way round: the bulge from a corner to the next is then that to the one before.
void reverse(Loop& loop) {
  std::ranges::reverse(loop.corners);
  std::vector<double> bulges(loop.bulges.size());
  for (size_t i = 0; i < bulges.size(); ++i)
    bulges[i] = -loop.bulges[(2 * bulges.size() - 2 - i) % bulges.size()];
  loop.bulges = std::move(bulges);
}

double extent_of(const std::vector<Vec3>& corners) {
  Box3 box;
  for (const Vec3& p : corners) box.add(p);
  return corners.empty() ? 0 : norm(box.max - box.min);
}

void drop_repeated(Loop& loop) {
  for (size_t i = 0; i < loop.corners.size() && loop.corners.size() > 1;) {
    if (loop.corners[i] == loop.corners[(i + 1) % loop.corners.size()]) {
      loop.corners.erase(loop.corners.begin() + static_cast<std::ptrdiff_t>(i));
      loop.bulges.erase(loop.bulges.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

}  // namespace

uint32_t ModelBuilder::part_of_layer(const std::string& layer) {
  const auto [at, is_new] = layers_.try_emplace(layer, static_cast<uint32_t>(model_.parts.size()));
  if (is_new) model_.parts.push_back({layer, class_of_layer(layer), kNoParent});
  return at->second;
}

uint32_t ModelBuilder::part_told(const Told& told, const std::string& layer) {
  if (told.number < 0) return part_of_layer(layer);
  const auto [at, is_new] =
      told_parts_.try_emplace(told.number, static_cast<uint32_t>(model_.parts.size()));
  if (is_new) model_.parts.push_back(told.part);
  return at->second;
}

void ModelBuilder::add(Loop loop) {
  for (Vec3& p : loop.corners) p = p * scale_;
  drop_repeated(loop);
  const double extent = extent_of(loop.corners);
  Vec3 normal = loop.normal;
  if (norm(normal) == 0) {
    const Vec3 twice = twice_area_of(loop.corners);
    if (norm(twice) <= kSliver * extent * extent) return;
    normal = normalized(twice);
  }
  const double area = area_of(loop, normal);
  if (std::fabs(area) <= kSliver * extent * extent) return;
  const uint32_t part =
      loop.told.is_ours ? part_told(loop.told, loop.layer) : part_of_layer(loop.layer);
  if (loop.told.is_ours && is_hole_of_last(loop, normal)) {
    // The outline once more stands for an opening that is no hole.
    if (loop.corners != last_.corners) add_hole(std::move(loop), part);
    return;
  }
  if (area < 0) reverse(loop);
  const uint32_t id =
      loop.told.is_ours ? loop.told.face : static_cast<uint32_t>(model_.faces.size());
  last_ = {loop.told.face, loop.corners, loop.told.is_ours};
  add_face(std::move(loop), normal, part, id);
}

// Of the same number, in the same plane, inside the outline.
bool ModelBuilder::is_hole_of_last(const Loop& loop, const Vec3& normal) const {
  if (!last_.is_open || last_.face != loop.told.face || model_.faces.empty()) return false;
  const Face& face = model_.faces.back();
  if (norm(cross(face.plane.normal, normal)) > kSamePlane) return false;
  if (loop.corners == last_.corners) return true;
  const PlaneAxes axes = axes_of(face.plane.normal);
  std::vector<Vec2> outline;
  for (const Vec3& p : last_.corners) outline.push_back(axes.project(p, last_.corners[0]));
  return std::ranges::all_of(loop.corners, [&](const Vec3& p) {
    return std::fabs(dot(p - last_.corners[0], face.plane.normal)) <= kInPlane_m &&
           contains(outline, axes.project(p, last_.corners[0]));
  });
}

void ModelBuilder::add_ring(const Loop& loop, uint32_t part) {
  model_.rings.push_back({model_.corners.size(), loop.corners.size(), part});
  for (size_t i = 0; i < loop.corners.size(); ++i) {
    const Vec3 &a = loop.corners[i], &b = loop.corners[(i + 1) % loop.corners.size()];
    model_.corners.push_back(vertices_.add(a));
    model_.sagittas.push_back(loop.bulges[i] * norm(b - a) / 2);
  }
}

void ModelBuilder::add_face(Loop loop, const Vec3& normal, uint32_t part, uint32_t id) {
  Face face;
  face.part = part;
  face.id = id;
  face.plane.normal = normal;
  face.plane.offset = dot(normal, loop.corners[0]);
  face.area_m2 = area_of(loop, normal);
  face.first_ring = model_.rings.size();
  face.ring_count = 1;
  add_ring(loop, kNoPart);
  model_.faces.push_back(face);
}

void ModelBuilder::add_hole(Loop loop, uint32_t part) {
  Face& face = model_.faces.back();
  if (area_of(loop, face.plane.normal) > 0) reverse(loop);
  face.area_m2 += area_of(loop, face.plane.normal);
  ++face.ring_count;
  const bool is_nameless = part == face.part;
  if (!is_nameless && model_.parts[part].parent == kNoParent) model_.parts[part].parent = face.part;
  add_ring(loop, is_nameless ? kNoPart : part);
}

void ModelBuilder::add(Patch patch) {
  const uint32_t part = part_of_layer(patch.layer);
  if (polygons_ == Polygons::kFaces) {
    for (const auto& polygon : patch.polygons) {
      Loop loop;
      loop.layer = patch.layer;
      for (const uint32_t at : polygon) loop.corners.push_back(patch.corners[at]);
      loop.bulges.assign(loop.corners.size(), 0);
      add(std::move(loop));
    }
    return;
  }
  std::vector<uint32_t> numbers;
  for (const Vec3& p : patch.corners) numbers.push_back(vertices_.add(p * scale_));
  for (const auto& polygon : patch.polygons) {
    std::vector<uint32_t> corners;
    for (const uint32_t at : polygon) corners.push_back(numbers[at]);
    append_polygon(model_, corners, part);
  }
}

Model ModelBuilder::take() {
  // The numbers of triangles are their parts; beside faces, which have numbers too, they count on behind those.
  if (!model_.faces.empty() && !model_.triangle_faces.empty()) {
    uint32_t behind = 0;
    for (const Face& face : model_.faces) behind = std::max(behind, face.id + 1);
    for (uint32_t& id : model_.triangle_faces) id += behind;
  }
  if (std::ranges::all_of(model_.sagittas, [](double s) { return s == 0; }))
    model_.sagittas.clear();
  return std::move(model_);
}

}  // namespace jalon::dxf
