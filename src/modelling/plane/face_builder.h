// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "model/model.h"
#include "modelling/plane/vector_plane.h"

namespace jalon {

/// Vertices that several planes use; each comes into the model when the first of them does use it.
struct SharedVertices {
  std::vector<Vec3> positions;
  std::vector<uint32_t> vertices;  ///< of the model; kNoVertex: not yet
};
constexpr uint32_t kNoVertex = ~uint32_t{0};

/// Vertices of the model that belong to one plane and what is parallel to it: equal (u, v, w) are one vertex.
class PlaneVertices {
 public:
  PlaneVertices(Model& model, SharedVertices& shared, const PlaneFrame& frame)
      : model_(&model), shared_(&shared), frame_(frame) {}

  /// w: in front of the plane.
  uint32_t at(const Vec2& p, double w = 0);
  /// kNoVertex when nothing has asked for this one yet.
  uint32_t find(const Vec2& p, double w) const;
  /// The vertex at this place of the plane is the shared one of this index.
  void share(const Vec2& p, size_t index) { shares_[{p.u, p.v}] = index; }
  Vec3 lift(const Vec2& p, double w) const;
  const PlaneFrame& frame() const { return frame_; }

 private:
  Model* model_;
  SharedVertices* shared_;
  PlaneFrame frame_;
  std::map<std::pair<double, double>, size_t> shares_;
  std::map<std::tuple<double, double, double>, uint32_t> known_;
};

/// One corner of a ring, and the arc from it to the next.
struct RingCorner {
  uint32_t vertex = 0;
  double sagitta_m = 0;
};
struct PartRing {
  std::vector<RingCorner> corners;
  uint32_t part = kNoPart;
};

/// The corners of a ring as vertices, w in front of the plane. After: one corner each, in their
/// order.
PartRing part_ring(PlaneVertices& vertices, const VectorRing& ring, double w = 0);
/// Walked the other way, for a face that looks the other way: an arc keeps its place and its sign.
PartRing turned(const PartRing& ring);

/// Appends a face of these rings, the outline first. Before: their vertices are in the model and
/// lie in face.plane. After: its area is that of the rings, arcs included.
void append_face(Model& model, Face face, const std::vector<PartRing>& rings);
/// A planar face through corners given in order, anticlockwise for who sees it against normal.
void append_polygon(Model& model, uint32_t part, const std::vector<uint32_t>& corners,
                    const Vec3& normal);
/// Appends a part and gives its index.
uint32_t append_part(Model& model, std::string name, const char* part_class, uint64_t parent,
                     Evidence evidence);

}  // namespace jalon
