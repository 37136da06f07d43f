// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/vertical_pieces.h"

#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "model/part_classes.h"
#include "model/polygon_triangles.h"
#include "spatial/union_find.h"

namespace jalon {

namespace {

struct RawPiece {
  uint32_t face = kNoFace, part = kNoPart;
  Vec3 area;  ///< twice the area, along the normal
  std::vector<Vec3> corners;
};

std::vector<RawPiece> raw_pieces(const Model& model) {
  std::vector<RawPiece> made;
  for (uint32_t f = 0; f < model.faces.size(); ++f) {
    const Face& face = model.faces[f];
    const Ring& ring = model.rings[face.first_ring];  // the outline; openings are filled
    RawPiece piece{f, face.part, {}, {}};
    for (uint64_t c = ring.first; c < ring.first + ring.count; ++c)
      piece.corners.push_back(model.vertices[model.corners[c]]);
    made.push_back(std::move(piece));
  }
  if (made.empty())
    for (const auto& [a, b, c] : model.triangles)
      made.push_back(
          {kNoFace, kNoPart, {}, {model.vertices[a], model.vertices[b], model.vertices[c]}});
  for (RawPiece& piece : made) piece.area = newell_normal(piece.corners);
  return made;
}

// The highest part of class "building" above a part; kNoPart without.
uint32_t building_part(const Model& model, uint32_t part) {
  uint32_t found = kNoPart;
  for (uint64_t p = part; p < model.parts.size(); p = model.parts[p].parent)
    if (model.parts[p].part_class == part_class::kBuilding) found = static_cast<uint32_t>(p);
  return found;
}

// What shares corners, rounded to a millimetre.
UnionFind hanging_together(const std::vector<RawPiece>& pieces) {
  constexpr double kSame_m = 1e-3;
  UnionFind groups(pieces.size());
  std::map<std::array<int64_t, 3>, uint32_t> first_at;
  for (uint32_t i = 0; i < pieces.size(); ++i)
    for (const Vec3& p : pieces[i].corners) {
      const auto key = [](double x) { return static_cast<int64_t>(std::llround(x / kSame_m)); };
      const auto [found, is_new] = first_at.try_emplace({key(p.x), key(p.y), key(p.z)}, i);
      if (!is_new) groups.join(found->second, i);
    }
  return groups;
}

}  // namespace

VerticalPieces vertical_pieces(const Model& model, double tilt_rad) {
  const std::vector<RawPiece> raw = raw_pieces(model);
  UnionFind groups = hanging_together(raw);
  VerticalPieces made;
  // Buildings are numbered as they come: by their part, or by their group behind all parts.
  std::unordered_map<uint64_t, uint32_t> number_of;
  const auto key_of = [&](uint32_t i, uint32_t part) -> uint64_t {
    return part != kNoPart ? part : model.parts.size() + groups.find(i);
  };
  std::vector<uint32_t> others;
  for (uint32_t i = 0; i < raw.size(); ++i) {
    const RawPiece& piece = raw[i];
    const double length = norm(piece.area);
    if (!(length > 0)) continue;
    if (std::fabs(piece.area.z) > length * std::sin(tilt_rad)) {
      if (piece.face != kNoFace) others.push_back(i);
      continue;
    }
    const uint32_t part = building_part(model, piece.part);
    const uint64_t key = key_of(i, part);
    const auto [found, is_new] =
        number_of.try_emplace(key, static_cast<uint32_t>(made.buildings.size()));
    if (is_new)
      made.buildings.push_back(part != kNoPart && !model.parts[part].name.empty()
                                   ? model.parts[part].name
                                   : "building " + std::to_string(made.buildings.size() + 1));
    made.pieces.push_back(
        {found->second, piece.face, normalized({piece.area.x, piece.area.y, 0}), piece.corners});
  }
  for (const uint32_t i : others) {
    const auto found = number_of.find(key_of(i, building_part(model, raw[i].part)));
    made.others.push_back({raw[i].face, found == number_of.end() ? kNoPart : found->second});
  }
  return made;
}

}  // namespace jalon
