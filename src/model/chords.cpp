// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/chords.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.h"
#include "base/numbers.h"
#include "model/topology.h"

namespace jalon {

namespace {

constexpr double kSameArc_m =
    1e-6;  // between the apexes of an arc as two rings tell it: rounding of map coordinates

bool is_arc(double sagitta_m) { return sagitta_m != 0 && std::isfinite(sagitta_m); }

Vec3 apex_of(const Vec3& a, const Vec3& b, double sagitta_m, const Vec3& normal) {
  return a + 0.5 * (b - a) + sagitta_m * normalized(cross(b - a, normal));
}

/// Gives each arc its chord vertices once, whichever ring comes first.
class Chords {
 public:
  Chords(Model& model, double chord_error_m) : model_(model), chord_error_m_(chord_error_m) {}

  /// Appends the vertices between from and to, in the order of the walk.
  void append(std::vector<uint32_t>& corners, uint32_t from, uint32_t to, double sagitta_m,
              const Vec3& normal) {
    // Walked the other way an arc bulges to the other side: every arc is made from its lower vertex.
    const bool forward = from < to;
    const Chain& chain =
        forward ? chain_of(from, to, sagitta_m, normal) : chain_of(to, from, -sagitta_m, normal);
    for (uint32_t k = 0; k < chain.count; ++k)
      corners.push_back(chain.first + (forward ? k : chain.count - 1 - k));
  }

 private:
  struct Chain {
    Vec3 apex;
    uint32_t first = 0, count = 0;
  };

  const Chain& chain_of(uint32_t low, uint32_t high, double sagitta_m, const Vec3& normal) {
    const Vec3 a = model_.vertices[low], b = model_.vertices[high];
    const Vec3 apex = apex_of(a, b, sagitta_m, normal);
    std::vector<Chain>& known = chains_[{low, high}];
    for (const Chain& chain : known)
      if (norm(chain.apex - apex) <= kSameArc_m) return chain;
    const std::vector<Vec3> points = arc_points(a, b, sagitta_m, normal, chord_error_m_);
    if (model_.vertices.size() + points.size() > std::numeric_limits<uint32_t>::max())
      fail(Status::kLimit, "a model holds at most 2^32 vertices");
    known.push_back({apex, static_cast<uint32_t>(model_.vertices.size()),
                     static_cast<uint32_t>(points.size())});
    model_.vertices.insert(model_.vertices.end(), points.begin(), points.end());
    return known.back();
  }

  Model& model_;
  double chord_error_m_;
  std::map<std::pair<uint32_t, uint32_t>, std::vector<Chain>> chains_;
};

Vec3 newell(const Model& model, const Ring& ring) {
  Vec3 sum;
  const auto corner = [&](uint64_t i) { return model.vertices[model.corners[ring.first + i]]; };
  for (uint64_t i = 2; i < ring.count; ++i)
    sum += cross(corner(i - 1) - corner(0), corner(i) - corner(0));
  return sum;
}

}  // namespace

bool has_arcs(const Model& model) { return std::ranges::any_of(model.sagittas, is_arc); }

Vec3 normal_of(const Model& model, const Face& face) {
  const double length = norm(face.plane.normal);
  // Readers of meshes and hand-made faces may leave it out; a stated one has length 1.
  if (length > 0.5 && length < 2) return face.plane.normal / length;
  return face.ring_count == 0 ? Vec3{} : normalized(newell(model, model.rings[face.first_ring]));
}

std::vector<Vec3> arc_points(const Vec3& a, const Vec3& b, double sagitta_m, const Vec3& normal,
                             double chord_error_m) {
  const Vec3 along = normalized(b - a);
  const Vec3 left = normalized(cross(normal, along));
  if (!is_arc(sagitta_m) || squared_norm(left) == 0) return {};
  std::vector<Vec2> flat;
  append_arc(flat, {0, 0}, {norm(b - a), 0}, sagitta_m, chord_error_m);
  std::vector<Vec3> out;
  for (size_t k = 1; k < flat.size(); ++k) out.push_back(a + flat[k].u * along + flat[k].v * left);
  return out;
}

Model with_chords(const Model& model, double chord_error_m) {
  Model out = model;
  out.corners.clear();
  out.sagittas.clear();
  Chords chords(out, chord_error_m);
  std::vector<uint8_t> done(model.rings.size(), 0);
  const auto add_ring = [&](size_t r, const Vec3& normal) {
    const Ring& ring = model.rings[r];
    done[r] = 1;
    out.rings[r].first = out.corners.size();
    for (uint64_t i = 0; i < ring.count; ++i) {
      const uint32_t here = model.corners[ring.first + i],
                     next = model.corners[ring.first + (i + 1) % ring.count];
      out.corners.push_back(here);
      if (is_arc(model.sagitta(ring.first + i)))
        chords.append(out.corners, here, next, model.sagitta(ring.first + i), normal);
    }
    out.rings[r].count = out.corners.size() - out.rings[r].first;
  };
  for (const Face& face : model.faces) {
    const Vec3 normal = normal_of(model, face);
    for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r)
      add_ring(r, normal);
  }
  for (size_t r = 0; r < model.rings.size(); ++r)
    if (done[r] == 0) add_ring(r, {});
  if (!out.vertex_covariances.empty()) {
    std::array<double, 9> unknown{};
    unknown.fill(kNaN);
    out.vertex_covariances.resize(out.vertices.size(), unknown);
  }
  return out;
}

}  // namespace jalon
