// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/clearance/part_triangles.h"

#include <algorithm>

#include "base/error.h"
#include "model/chords.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

/// A part of a gauge is convex when its corners and the middles of its triangles lie this near to its hull's surface.
constexpr double kConvex_m = 1e-6;

// For each part whether it is the wanted one or below it. Parts may stand before their parents.
std::vector<char> parts_below(const Model& model, uint64_t wanted) {
  std::vector<char> below(model.parts.size(), 0);
  for (size_t i = 0; i < below.size(); ++i) {
    uint64_t at = i;
    for (size_t steps = 0; at < model.parts.size() && steps <= model.parts.size(); ++steps) {
      if (at == wanted) below[i] = 1;
      at = model.parts[at].parent;
    }
  }
  return below;
}

class Collector {
 public:
  explicit Collector(const Model& model)
      : model_(model), number_(model.vertices.size(), ~uint32_t{0}) {}

  void add(const std::array<uint32_t, 3>& triangle, const TriangleSource& source) {
    std::array<uint32_t, 3> renumbered;
    for (size_t k = 0; k < 3; ++k) {
      uint32_t& number = number_[triangle[k]];
      if (number == ~uint32_t{0}) {
        number = static_cast<uint32_t>(out.vertices.size());
        out.vertices.push_back(model_.vertices[triangle[k]]);
      }
      renumbered[k] = number;
    }
    out.triangles.push_back(renumbered);
    out.sources.push_back(source);
  }

  PartTriangles out;

 private:
  const Model& model_;
  std::vector<uint32_t> number_;
};

// wanted(part): kNoRow stands for triangles of no part.
template <class Wanted>
PartTriangles collect(const Model& model, Wanted wanted) {
  Collector collector(model);
  for (size_t f = 0; f < model.faces.size(); ++f) {
    const uint64_t part = model.faces[f].part < model.parts.size() ? model.faces[f].part : kNoRow;
    if (!wanted(part)) continue;
    for (const auto& t : triangles_of_face(model, model.faces[f]))
      collector.add(t, {part, f, kNoRow});
  }
  const bool by_part = is_mesh_by_part(model);
  for (const uint32_t t : loose_triangles(model)) {
    const uint64_t part = by_part ? model.triangle_faces[t] : kNoRow;
    if (wanted(part)) collector.add(model.triangles[t], {part, kNoRow, t});
  }
  return std::move(collector.out);
}

ConvexPiece convex_piece_of(const PartTriangles& surface, const std::string& name) {
  ConvexPiece piece = ConvexPiece::hull(surface.vertices);
  const auto inside = [&](const Vec3& p) { return piece.distance(p).value < -kConvex_m; };
  for (const auto& t : surface.triangles) {
    const Vec3 a = surface.vertices[t[0]], b = surface.vertices[t[1]], c = surface.vertices[t[2]];
    if (inside(a) || inside(b) || inside(c) || inside((a + b + c) / 3))
      fail(Status::kInvalidArgument, "%.100s of the gauge is not convex", name.c_str());
  }
  return piece;
}

// of(surface, name) for each part of a gauge that has a surface of its own, then for what is of no part.
template <class Of>
void for_each_piece(const Model& model, double chord_m, Of of) {
  if (has_arcs(model)) return for_each_piece(with_chords(model, chord_m), chord_m, of);
  for (uint64_t p = 0; p < model.parts.size(); ++p) {
    const PartTriangles surface = collect(model, [&](uint64_t part) { return part == p; });
    if (!surface.triangles.empty())
      of(surface, "part " + std::to_string(p) + " (" + model.parts[p].name + ")");
  }
  const PartTriangles rest = collect(model, [](uint64_t part) { return part == kNoRow; });
  if (!rest.triangles.empty()) of(rest, "the mesh");
}

}  // namespace

PartTriangles triangles_of_part(const Model& model, uint64_t part, double chord_m) {
  if (part != kWholeModel && part >= model.parts.size())
    fail(Status::kInvalidArgument, "there is no part %llu; the model has %zu",
         static_cast<unsigned long long>(part), model.parts.size());
  if (has_arcs(model)) return triangles_of_part(with_chords(model, chord_m), part, chord_m);
  const std::vector<char> below =
      part == kWholeModel ? std::vector<char>{} : parts_below(model, part);
  PartTriangles found = collect(
      model, [&](uint64_t p) { return part == kWholeModel || (p != kNoRow && below[p] != 0); });
  if (found.triangles.empty())
    fail(Status::kInsufficientData, "the model or its part has no surface");
  return found;
}

std::vector<ConvexPiece> gauge_of_model(const Model& model, double chord_m) {
  std::vector<ConvexPiece> pieces;
  for_each_piece(model, chord_m, [&](const PartTriangles& surface, const std::string& name) {
    pieces.push_back(convex_piece_of(surface, name));
  });
  if (pieces.empty()) fail(Status::kInsufficientData, "the gauge has no surface");
  return pieces;
}

std::vector<std::vector<Vec3>> gauge_corners(const Model& model, double chord_m) {
  std::vector<std::vector<Vec3>> corners;
  for_each_piece(model, chord_m, [&](const PartTriangles& surface, const std::string&) {
    corners.push_back(surface.vertices);
  });
  return corners;
}

}  // namespace jalon
