// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The frame in which models of one facade without a truth are compared.
#pragma once

#include "facade_truth.h"
#include "model/part_classes.h"

namespace jalon::test {

/// The largest wall of a model stands for the truth's first, whose axes all is compared in.
inline FacadeTruth axes_of_largest(const Model& model) {
  FacadeTruth out;
  const Face* largest = nullptr;
  for (const Face& face : model.faces)
    if (model.parts[face.part].part_class == part_class::kWall &&
        (largest == nullptr || face.area_m2 > largest->area_m2))
      largest = &face;
  if (largest == nullptr) return out;
  TruthWall& wall = out.walls.emplace_back();
  const WallAxes axes(largest->plane,
                      model.vertices[model.corners[model.rings[largest->first_ring].first]]);
  wall.origin = axes.origin, wall.along = axes.u, wall.up = axes.v, wall.normal = axes.n;
  return out;
}

}  // namespace jalon::test
