// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/model.h"

namespace jalon {

/// A ring that shows where an opening is.
struct OpeningRing {
  size_t face = 0;
  uint64_t ring = 0;  ///< of Model::rings
};

/// Of each part: those of an opening, none for the other parts. The holes of walls that it fills; where it is no hole
/// (a door at the foot of its wall) the outlines of its own faces; where it has none those of what stands in it, the
/// reveals left out. Empty where nothing is drawn of it.
std::vector<std::vector<OpeningRing>> opening_rings(const Model& model);

/// Whether an opening is drawn under its own name: by a hole that it fills, or a face of its own.
bool has_own_ring(const Model& model, uint32_t part, const std::vector<OpeningRing>& rings);

}  // namespace jalon
