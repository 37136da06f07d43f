// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/numbers.h"
#include "model/model.h"
#include "report/settings.h"

namespace jalon {

/// A ring of a face, by indices.
struct FaceRing {
  size_t face = 0, ring = 0;
};

/// What tables and drawings tell of a window, a door or another opening.
struct OpeningRow {
  uint32_t part = kNoPart;  ///< kNoPart: a hole of a wall that the model does not name
  std::string name, part_class;
  double class_confidence = kNaN;
  Evidence evidence = Evidence::kNone;
  uint64_t copied_from = kNoParent;
  double width_m = 0, height_m = 0;  ///< of the upright box in the plane of the wall
  double depth_m = kNaN;
  double sigma_width_m = kNaN;  ///< NaN: not known
  double sigma_height_m = kNaN;
  double sigma_depth_m = kNaN;
  bool arched = false;  ///< its contour has an arc
  std::vector<FaceRing>
      contour;  ///< holes of the wall, or the outlines of its own faces where it is no hole
  std::vector<size_t> joinery;  ///< faces seen in it
  size_t wall = 0;  ///< face of the wall around it; where none is known that of its own contour
  size_t type = 0;

  bool is_copy() const { return evidence == Evidence::kCopied || copied_from != kNoParent; }
};

/// Openings of one class, form and size.
struct OpeningType {
  std::string
      tag;  ///< W1, W2 ... windows; D doors, G gateways, S shop fronts, V vents, R recesses, O other openings: by
            ///< falling number, then falling size
  std::string part_class;
  double width_m = 0, height_m = 0;  ///< means
  bool arched = false;
  size_t count = 0, copies = 0;
};

struct OpeningList {
  std::vector<OpeningRow> rows;    ///< in the order of the parts, or of the faces
  std::vector<OpeningType> types;  ///< in the order of part_class::kOpenings
};

/// How many openings there are of a class.
size_t count_of(const OpeningList& list, std::string_view part_class);

/// The openings of a model: its parts of class window, door, opening and the like. A model that has none of these (each
/// plane a face) gives the upright holes of its steep faces, without names. Openings whose width and height agree
/// within the tolerance are of one type.
OpeningList list_openings(const Model& model, double tolerance_m);

}  // namespace jalon
