// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "base/json_cursor.h"
#include "formats/city/tree.h"
#include "model/model.h"

namespace jalon::city {

/// Collects faces and solids from the boundaries of geometries. Faces name drafts of the tree as their parts until
/// finish().
class Boundaries {
 public:
  Boundaries(Model& model, Tree& tree) : model_(model), tree_(tree) {}

  /// One geometry of an object. depth: lists above the list of surfaces: 0 MultiSurface, 1 Solid, 2 MultiSolid.
  /// values: of its semantics, or nullptr; surfaces: the draft of each semantic surface.
  void read(JsonCursor& boundaries, JsonCursor* values, int depth, uint32_t object,
            const std::vector<uint32_t>& surfaces);

  /// Gives the holes their windows and doors, and all faces their parts.
  void finish(const std::vector<uint32_t>& new_index);
  size_t dropped() const { return dropped_; }  ///< faces without area

 private:
  using Rings = std::vector<std::vector<uint32_t>>;
  struct Closing {
    std::vector<uint32_t> ring;
    uint32_t draft = 0;
    bool is_face = false;  ///< it is a face as well, not only what closes a hole
  };

  void level(JsonCursor& boundaries, JsonCursor* values, int depth);
  void list_of_surfaces(JsonCursor& boundaries, JsonCursor* values);
  uint32_t draft_of_value(JsonCursor* values) const;
  Rings read_rings(JsonCursor& boundaries) const;
  void surface(Rings rings, uint32_t draft);
  void add_face(const Rings& rings, uint32_t draft);
  uint32_t common_part(const Solid& solid) const;

  Model& model_;
  Tree& tree_;
  uint32_t object_ = 0;
  const std::vector<uint32_t>* surfaces_ = nullptr;
  std::vector<Closing> closings_;
  size_t dropped_ = 0;
};

}  // namespace jalon::city
