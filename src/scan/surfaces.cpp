// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/surfaces.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "base/error.h"
#include "base/random.h"

namespace jalon {

namespace {

constexpr uint64_t kGlassKey = 0x67'6c'61'73'73;  // "glass": its streams are none of the rays'

/// Ids of the faces made of glass: parts of class "glass", and the panes of windows.
std::unordered_set<uint32_t> glass_ids(const Model& model) {
  std::unordered_set<uint32_t> ids;
  for (const Face& face : model.faces) {
    if (face.part >= model.parts.size()) continue;
    const Part& part = model.parts[face.part];
    const bool in_window =
        part.parent < model.parts.size() && model.parts[part.parent].part_class == "window";
    if (part.part_class == "glass" || (part.part_class == "pane" && in_window)) ids.insert(face.id);
  }
  return ids;
}

}  // namespace

Surfaces::Surfaces(const Model& model, const ScannedSurfaceSettings& settings, uint64_t seed,
                   Task& task)
    : model_(model), truth_(find_truth(model, settings.truth_min_area_m2, task)) {
  const double least = settings.glass_return_min, most = settings.glass_return_max;
  if (!(least <= most))
    fail(Status::kInvalidArgument, "glass_return_min is above glass_return_max");
  if (least == 1) return;
  const std::unordered_set<uint32_t> ids = glass_ids(model);
  if (ids.empty()) return;
  glass_.assign(model.triangles.size(), 1);
  for (size_t t = 0; t < glass_.size(); ++t)
    if (const uint32_t id = model.triangle_faces[t]; ids.contains(id))
      glass_[t] = least + (most - least) * RandomStream(seed ^ kGlassKey, id).uniform();
}

Vec3 Surfaces::normal(uint32_t triangle) const {
  const auto& [a, b, c] = model_.triangles[triangle];
  return normalized(
      cross(model_.vertices[b] - model_.vertices[a], model_.vertices[c] - model_.vertices[a]));
}

double Surfaces::cosine(uint32_t triangle, const Vec3& direction) const {
  return std::min(1.0, std::abs(dot(normal(triangle), direction)) / norm(direction));
}

}  // namespace jalon
