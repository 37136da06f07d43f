// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace jalon {

/// What the points of a feature code mean; the places of the names in code_table.cpp.
enum class CodeGeometry {
  kIgnored,         ///< stations, reference points: known, and no object
  kPoint,           ///< a point by itself
  kLine,            ///< a linkage without a class of points
  kPrism,           ///< linkage: the upper outline of a building and one low point
  kTwoCorners,      ///< opposite corners of an opening
  kThreePoints,     ///< two corners, and one of them once more at the frame
  kFourPoints,      ///< an opening with an inclined sill
  kOutline,         ///< linkage: the border of an opening
  kCylinderCentre,  ///< of an upright cylinder, at the foot; edge and top follow
  kCylinderEdge,
  kCylinderTop,
  kPipe,  ///< linkage: points of the axis where a pipe bends, one point of its skin
  kWallTarget,
  kDoorTarget,
  kWindowTarget,  ///< two a facade, one after the other
  kGutterTarget
};
const char* name_of(CodeGeometry geometry);

/// The sequences from ... to mean the same.
struct CodeRow {
  int64_t from = 0, to = 0;
  std::string name;  ///< "window"
  CodeGeometry geometry = CodeGeometry::kIgnored;
  int64_t class_code = 0;    ///< of its points
  double distance_m = 0.03;  ///< openings: a half-thickness, of the points about the plane
  bool is_hinged = false;    ///< its first point is on the side of the hinge
};

/// What stands behind the point of a code: the role of a point, whatever the object.
struct CodeModifiers {
  int64_t start = 2, next = 4, curve = 3, close = 0, offset = 8;
};
constexpr int64_t kNoModifier = -1;

/// The code table of a survey, drawn up before the field work.
struct CodeTable {
  std::string name;
  char separator = '+';  ///< between several codes of one point
  CodeModifiers modifiers;
  std::vector<CodeRow> rows;

  const CodeRow* find(int64_t sequence) const;  ///< nullptr: unknown
};

/// The ready-made tables as JSON, to start one's own from: codes of targets and of a total-station survey.
extern const char* const kTargetCodeTable;
extern const char* const kSurveyCodeTable;

/// Reads a table; Error(kFormat) says what is wrong with it, Error(kInvalidArgument) that it is no JSON.
CodeTable code_table_from_json(std::string_view text);

}  // namespace jalon
