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

std::unordered_set<uint32_t> dark_ids(const Model& model) {
  std::unordered_set<uint32_t> ids;
  for (const Face& face : model.faces)
    if (face.part < model.parts.size() && model.parts[face.part].part_class == "dark")
      ids.insert(face.id);
  return ids;
}

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
  // 1. What is dark, and what is glass that lets something through.
  const std::unordered_set<uint32_t> dark = dark_ids(model);
  const std::unordered_set<uint32_t> glass = least == 1 ? dark : glass_ids(model);
  if (dark.empty() && (least == 1 || glass.empty())) return;
  // 2. Their shares.
  const size_t n = model.triangles.size();
  returned_.assign(n, 1);
  if (!dark.empty()) dark_.assign(n, 0);
  for (size_t t = 0; t < n; ++t) {
    const uint32_t id = model.triangle_faces[t];
    if (dark.contains(id)) returned_[t] = 0, dark_[t] = 1;
    else if (glass.contains(id))
      returned_[t] = least + (most - least) * RandomStream(seed ^ kGlassKey, id).uniform();
  }
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
