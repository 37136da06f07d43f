// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/opening_rings.h"

#include "model/part_classes.h"

namespace jalon {

namespace {

bool is_opening(const Model& model, uint64_t part) {
  return part < model.parts.size() && part_class::is_opening(model.parts[part].part_class);
}

// The opening that a face stands in: its part or the nearest above; kNoPart for none, and for reveals.
uint32_t opening_around(const Model& model, uint32_t part) {
  if (part < model.parts.size() && model.parts[part].part_class == part_class::kReveal)
    return kNoPart;
  uint64_t at = part;
  for (size_t steps = 0; at < model.parts.size() && steps <= model.parts.size(); ++steps) {
    if (is_opening(model, at)) return static_cast<uint32_t>(at);
    at = model.parts[at].parent;
  }
  return kNoPart;
}

}  // namespace

std::vector<std::vector<OpeningRing>> opening_rings(const Model& model) {
  std::vector<std::vector<OpeningRing>> holes(model.parts.size()), own(model.parts.size()),
      inside(model.parts.size());
  for (size_t f = 0; f < model.faces.size(); ++f) {
    const Face& face = model.faces[f];
    for (uint64_t r = 1; r < face.ring_count; ++r)
      if (const uint32_t part = model.rings[face.first_ring + r].part; is_opening(model, part))
        holes[part].push_back({f, face.first_ring + r});
    if (face.ring_count == 0) continue;
    if (const uint32_t part = opening_around(model, face.part); part != kNoPart)
      (part == face.part ? own : inside)[part].push_back({f, face.first_ring});
  }
  for (size_t part = 0; part < holes.size(); ++part) {
    if (holes[part].empty()) holes[part] = std::move(own[part]);
    if (holes[part].empty()) holes[part] = std::move(inside[part]);
  }
  return holes;
}

bool has_own_ring(const Model& model, uint32_t part, const std::vector<OpeningRing>& rings) {
  if (rings.empty()) return false;
  const OpeningRing& first = rings.front();
  return model.rings[first.ring].part == part || model.faces[first.face].part == part;
}

}  // namespace jalon
