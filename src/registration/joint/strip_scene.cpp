// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_scene.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "model/buildings/part_numbers.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

uint32_t parts_of(const Model& model, const char* part_class) {
  return static_cast<uint32_t>(
      std::count_if(model.parts.begin(), model.parts.end(),
                    [&](const Part& p) { return p.part_class == part_class; }));
}

// A strip stands where its face stands; several faces of one strip are in one plane.
GivenStrip given_strip(const Face& face, const PartNumbers& n) {
  const Vec3& normal = face.plane.normal;
  const double level = std::hypot(normal.x, normal.y);
  constexpr double kUpright = 0.996;  // 5 degrees, as building_strips takes facades
  if (n.block == kNoStrip || n.facade == kNoStrip)
    fail(Status::kInvalidArgument, "strip %u of the model is of no facade or of no block", n.strip);
  if (!(level > kUpright) || !std::isfinite(face.plane.offset))
    fail(Status::kInvalidArgument, "strip %u of the model does not stand upright", n.strip);
  return {n.block, n.facade, {normal.x / level, normal.y / level}, face.plane.offset / level, 0};
}

// A strip's middle along its facade, from left to right as one stands inside.
void place_strips(StripScene& scene) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<Vec2> ends(scene.strips.size(), Vec2{kFar, -kFar});
  for (size_t t = 0; t < scene.face_of.size(); ++t) {
    const uint32_t s = scene.strip_of_face[scene.face_of[t]];
    if (s == kNoStrip) continue;
    for (size_t k = 0; k < 3; ++k) {
      const Vec3& c = scene.corners[3 * t + k];
      const double at = dot(Vec2{-scene.strips[s].normal.v, scene.strips[s].normal.u}, {c.x, c.y});
      ends[s] = {std::min(ends[s].u, at), std::max(ends[s].v, at)};
    }
  }
  for (size_t s = 0; s < ends.size(); ++s)
    if (ends[s].u <= ends[s].v) scene.strips[s].place_m = (ends[s].u + ends[s].v) / 2;
}

}  // namespace

StripScene strip_scene(const Model& model, bool occluders) {
  StripScene scene;
  scene.blocks = parts_of(model, part_class::kBlock);
  scene.facades = parts_of(model, part_class::kFacade);
  scene.strips.resize(parts_of(model, part_class::kStrip));
  if (scene.strips.empty())
    fail(Status::kInvalidArgument,
         "the model has no strips: jalon_model_building_strips makes them of its facades");
  const std::vector<PartNumbers> numbers = part_numbers(model);
  for (uint32_t f = 0; f < model.faces.size(); ++f) {
    const Face& face = model.faces[f];
    const PartNumbers n =
        face.part < numbers.size() ? numbers[face.part] : PartNumbers{kNoStrip, kNoStrip, kNoStrip};
    scene.strip_of_face.push_back(n.strip);
    scene.block_of_face.push_back(n.block);
    if (n.strip != kNoStrip) scene.strips[n.strip] = given_strip(face, n);
    else if (!occluders) continue;
    for (const auto& triangle : triangles_of_face(model, face)) {
      for (const uint32_t v : triangle) scene.corners.push_back(model.vertices[v]);
      scene.face_of.push_back(f);
    }
  }
  place_strips(scene);
  return scene;
}

std::shared_ptr<const TriangleTree> tree_of(const StripScene& scene, const BuildingOffsets& offsets,
                                            Task& task) {
  std::vector<Vec3> corners = scene.corners;
  std::vector<std::array<uint32_t, 3>> triangles;
  for (uint32_t t = 0; t < scene.face_of.size(); ++t) {
    const uint32_t face = scene.face_of[t], strip = scene.strip_of_face[face],
                   block = scene.block_of_face[face];
    Vec2 by;
    if (block != kNoStrip) by = offsets.blocks[block];
    if (strip != kNoStrip) {
      const GivenStrip& given = scene.strips[strip];
      by = by + given.normal * (offsets.facades[given.facade] + offsets.strips[strip]);
    }
    for (uint32_t k = 0; k < 3; ++k) corners[3 * t + k] += Vec3{by.u, by.v, 0};
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return TriangleTree::build(corners, triangles, task);
}

}  // namespace jalon
