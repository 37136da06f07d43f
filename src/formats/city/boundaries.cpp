// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/city/boundaries.h"

#include <algorithm>

#include "formats/face_geometry.h"

namespace jalon::city {

namespace {

std::vector<uint32_t> sorted(std::vector<uint32_t> ring) {
  std::ranges::sort(ring);
  return ring;
}

}  // namespace

void Boundaries::read(JsonCursor& boundaries, JsonCursor* values, int depth, uint32_t object,
                      const std::vector<uint32_t>& surfaces) {
  object_ = object;
  surfaces_ = &surfaces;
  level(boundaries, values, depth);
}

// A list of solids (2), of shells (1) or of surfaces (0); values have the same lists, or null for all below.
void Boundaries::level(JsonCursor& boundaries, JsonCursor* values, int depth) {
  if (values != nullptr && values->kind() == JsonCursor::Kind::kNull) {
    values->null();
    values = nullptr;
  }
  if (depth == 0) return list_of_surfaces(boundaries, values);
  const size_t first_face = model_.faces.size();
  boundaries.begin_array();
  if (values != nullptr) values->begin_array();
  while (boundaries.next_element()) {
    if (values != nullptr && !values->next_element())
      values->refuse("a semantic value for each shell");
    level(boundaries, values, depth - 1);
  }
  if (values != nullptr && values->next_element())
    values->refuse("no more semantic values than shells");
  if (depth == 1 && model_.faces.size() > first_face)
    model_.solids.push_back({object_, first_face, model_.faces.size() - first_face});
}

void Boundaries::list_of_surfaces(JsonCursor& boundaries, JsonCursor* values) {
  boundaries.begin_array();
  if (values != nullptr) values->begin_array();
  while (boundaries.next_element()) {
    if (values != nullptr && !values->next_element())
      values->refuse("a semantic value for each surface");
    const uint32_t draft = draft_of_value(values);
    surface(read_rings(boundaries), draft);
  }
  if (values != nullptr && values->next_element())
    values->refuse("no more semantic values than surfaces");
}

uint32_t Boundaries::draft_of_value(JsonCursor* values) const {
  if (values == nullptr) return object_;
  if (values->kind() == JsonCursor::Kind::kNull) {
    values->null();
    return object_;
  }
  const int64_t value = values->integer();
  if (value < 0 || static_cast<uint64_t>(value) >= surfaces_->size())
    values->refuse("the number of a semantic surface");
  return (*surfaces_)[static_cast<size_t>(value)];
}

Boundaries::Rings Boundaries::read_rings(JsonCursor& boundaries) const {
  Rings rings;
  for (boundaries.begin_array(); boundaries.next_element();) {
    std::vector<uint32_t> ring;
    for (boundaries.begin_array(); boundaries.next_element();) {
      const int64_t vertex = boundaries.integer();
      if (vertex < 0 || static_cast<uint64_t>(vertex) >= model_.vertices.size())
        boundaries.refuse("the number of a vertex");
      if (ring.empty() || ring.back() != static_cast<uint32_t>(vertex))
        ring.push_back(static_cast<uint32_t>(vertex));
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() >= 3) rings.push_back(std::move(ring));
    else if (rings.empty())
      rings.emplace_back();  // an outline without extent keeps its place before the holes
  }
  return rings;
}

void Boundaries::surface(Rings rings, uint32_t draft) {
  if (rings.empty() || rings[0].empty()) {
    ++dropped_;
    return;
  }
  const bool is_closing = tree_.at(draft).is_closing && rings.size() == 1;
  if (rings.size() == 1 && tree_.at(draft).is_opening)
    closings_.push_back({rings[0], draft, !is_closing});
  if (!is_closing) add_face(rings, draft);
}

void Boundaries::add_face(const Rings& rings, uint32_t draft) {
  Face face;
  face.part = draft;
  face.first_ring = model_.rings.size();
  face.ring_count = rings.size();
  const size_t first_corner = model_.corners.size();
  for (const std::vector<uint32_t>& ring : rings) {
    model_.rings.push_back({model_.corners.size(), ring.size()});
    model_.corners.insert(model_.corners.end(), ring.begin(), ring.end());
  }
  if (!measure_face(model_, face)) {
    model_.rings.resize(face.first_ring);
    model_.corners.resize(first_corner);
    ++dropped_;
    return;
  }
  Draft& told = tree_.at(draft);
  const size_t k = told.faces_seen++;
  face.id =
      k < told.face_ids.size() ? told.face_ids[k] : static_cast<uint32_t>(model_.faces.size());
  if (k < told.sigmas_m.size()) face.sigma_m = told.sigmas_m[k];
  model_.faces.push_back(face);
}

// The part that all faces of a solid belong to; that of the first where there is none.
uint32_t Boundaries::common_part(const Solid& solid) const {
  const auto path_of = [&](uint64_t part) {
    std::vector<uint64_t> path;
    for (; part < model_.parts.size(); part = model_.parts[part].parent) path.push_back(part);
    std::ranges::reverse(path);
    return path;
  };
  std::vector<uint64_t> common = path_of(model_.faces[solid.first_face].part);
  const uint32_t first = model_.faces[solid.first_face].part;
  for (uint64_t f = 1; f < solid.face_count; ++f) {
    const std::vector<uint64_t> path = path_of(model_.faces[solid.first_face + f].part);
    const size_t n = std::min(path.size(), common.size());
    common.resize(static_cast<size_t>(
        std::mismatch(common.begin(), common.begin() + static_cast<std::ptrdiff_t>(n), path.begin())
            .first -
        common.begin()));
  }
  return common.empty() ? first : static_cast<uint32_t>(common.back());
}

void Boundaries::finish(const std::vector<uint32_t>& new_index) {
  std::map<std::vector<uint32_t>, uint64_t> holes;  // by their vertices
  for (const Face& face : model_.faces)
    for (uint64_t r = face.first_ring + 1; r < face.first_ring + face.ring_count; ++r) {
      const auto begin =
          model_.corners.begin() + static_cast<std::ptrdiff_t>(model_.rings[r].first);
      holes.try_emplace(sorted({begin, begin + static_cast<std::ptrdiff_t>(model_.rings[r].count)}),
                        r);
    }
  for (Closing& closing : closings_) {
    const auto hole = holes.find(sorted(closing.ring));
    if (hole != holes.end()) model_.rings[hole->second].part = closing.draft;
    else if (!closing.is_face) add_face({std::move(closing.ring)}, closing.draft);
  }
  for (Face& face : model_.faces) face.part = new_index[face.part];
  for (Solid& solid : model_.solids) solid.part = common_part(solid);
  for (Ring& ring : model_.rings)
    if (ring.part != kNoPart) ring.part = new_index[ring.part];
}

}  // namespace jalon::city
