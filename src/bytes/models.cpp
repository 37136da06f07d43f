// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/models.h"

#include <algorithm>

namespace jalon {

namespace {

// Vertices that nothing knows of are no part; a model without parts names part 0.
bool is_part(const Model& model, uint32_t part) {
  return part < model.parts.size() || part == kNoPart || (model.parts.empty() && part == 0);
}

void require_parts(const ByteReader& reader, const Model& model) {
  const auto is_told = [&](const auto& item) { return is_part(model, item.part); };
  if (!std::all_of(model.faces.begin(), model.faces.end(), is_told))
    reader.refuse("a face is of a part that is not there");
  if (!std::all_of(model.rings.begin(), model.rings.end(), is_told))
    reader.refuse("a ring is filled by a part that is not there");
  if (!std::all_of(model.solids.begin(), model.solids.end(), is_told))
    reader.refuse("a solid is of a part that is not there");
  for (const Part& part : model.parts) {
    if (part.parent != kNoParent && part.parent >= model.parts.size())
      reader.refuse("a part is below one that is not there");
    if (part.copied_from != kNoParent && part.copied_from >= model.parts.size())
      reader.refuse("a part repeats one that is not there");
    if (part.evidence > Evidence::kDerived)
      reader.refuse("evidence %d is unknown", static_cast<int>(part.evidence));
  }
}

// Each part is walked up from once: a walk that meets itself goes round.
void require_tree(const ByteReader& reader, const Model& model) {
  constexpr size_t kNotYet = ~size_t{0};
  std::vector<size_t> walk_of(model.parts.size(), kNotYet);
  for (size_t walk = 0; walk < model.parts.size(); ++walk) {
    size_t at = walk;
    while (walk_of[at] == kNotYet) {
      walk_of[at] = walk;
      const uint64_t parent = model.parts[at].parent;
      if (parent == kNoParent) break;
      at = parent;
      if (walk_of[at] == walk) reader.refuse("part %zu is below itself", at);
    }
  }
}

}  // namespace

void write_model(ByteWriter& writer, const Model& model) {
  writer.list(model.vertices);
  writer.list(model.vertex_covariances);
  writer.list(model.corners);
  writer.list(model.sagittas);
  writer.list(model.rings);
  writer.list(model.faces);
  writer.list(model.triangles);
  writer.list(model.triangle_faces);
  writer.list(model.parts);
  writer.list(model.solids);
  writer.item(model.crs);
}

Model read_model(ByteReader& reader) {
  Model model;
  reader.list(model.vertices);
  reader.list(model.vertex_covariances);
  reader.list(model.corners);
  reader.list(model.sagittas);
  reader.list(model.rings);
  reader.list(model.faces);
  reader.list(model.triangles);
  reader.list(model.triangle_faces);
  reader.list(model.parts);
  reader.list(model.solids);
  reader.item(model.crs);
  try {
    validate(model);
  } catch (const Error& error) {
    reader.refuse("%s", error.what());
  }
  require_parts(reader, model);
  require_tree(reader, model);
  return model;
}

}  // namespace jalon
