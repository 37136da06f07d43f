// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/numbers.h"
#include "modelling/plane/plane_frame.h"

namespace jalon {

/// Direction classes of straight parts in the plane (Boulaassal 2010, 4.3.1); arcs are their own class.
enum class EdgeDirection : uint8_t { kVertical, kHorizontal, kInclined, kArc };

/// What the position of an edge was taken from, by rising trust.
enum class EdgeSource : uint8_t {
  kContour,  ///< the border of the triangulation, moved out by the mean set-back
  kDensity,  ///< the place where the density of the segment's points falls to half
  kReveal,   ///< points of the reveal that ends at the edge
  kPlanes,   ///< the intersection with another plane of the segmentation
};

/// The edge from one corner of a ring to the next.
struct VectorEdge {
  double sagitta_m = 0;   ///< of an arc, as Model::sagittas; 0: straight
  double sigma_m = kNaN;  ///< standard deviation of its position across it
  EdgeDirection direction = EdgeDirection::kInclined;
  EdgeSource source = EdgeSource::kContour;
};

/// A closed chain in the plane; edges[i] runs from corners[i] to corners[i + 1].
struct VectorRing {
  std::vector<Vec2> corners;
  std::vector<VectorEdge> edges;
  std::vector<Vec2> contour;  ///< the points of the segment it was drawn from, the same way round
};

/// A simple polygon (anticlockwise) with holes (clockwise) that lie inside it and apart from each other.
struct VectorFace {
  VectorRing outline;
  std::vector<VectorRing> openings;
};

/// 2D vector model of one planar segment (Boulaassal 2010, 4.3.3).
struct VectorPlane {
  uint32_t label = 0;  ///< of the segment
  PlaneFrame frame;
  double spacing_m = 0;           ///< typical distance of neighbouring points
  double max_edge_m = 0;          ///< longest distance that counted as surface
  std::vector<VectorFace> faces;  ///< one a connected piece, largest first
};

/// Positive when the ring runs anticlockwise; what lies between arcs and their chords counts.
double signed_area(const VectorRing& ring);
/// Openings taken off.
double area(const VectorFace& face);
/// Corners with points on the arcs between, chords at most chord_error_m from them.
std::vector<Vec2> flattened(const VectorRing& ring, double chord_error_m);

}  // namespace jalon
