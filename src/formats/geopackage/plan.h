// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/model.h"

namespace jalon::gpkg {

/// Where a level cuts a face, or an opening in it.
struct SectionLine {
  uint32_t face = 0;
  uint32_t part = kNoPart;  ///< of the face, or the opening that fills the hole
  bool is_opening = false;  ///< in a hole of the face
  Vec3 from = {}, to = {};
};

/// The height at which these faces are cut: so much above their lowest upright corner; NaN where none stands upright.
double section_level_m(const Model& model, const std::vector<uint32_t>& faces, double height_m);

/// The section of upright faces of straight edges at a level: what is left of each between its holes and notches, then
/// the openings that fill the holes. In the order of the faces, along each.
std::vector<SectionLine> section_of(const Model& model, const std::vector<uint32_t>& faces,
                                    double level_m);

}  // namespace jalon::gpkg
