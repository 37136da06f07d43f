// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "segment/codes/code_list.h"

namespace jalon {

inline Vec2 in_plan(const Vec3& p) { return {p.x, p.y}; }

/// The space that an object's codes describe, relative to the local origin of its list.
struct CodeShape {
  enum class Kind { kNone, kPrism, kRectangle, kOutline, kPipe };
  Kind kind = Kind::kNone;
  std::vector<Vec2> polygon;  ///< prism: in XY; outline: along the wall from corner_a, and height
  Vec3 corner_a, corner_b;    ///< opposite corners; of an outline the ends of its base line
  std::vector<Vec3> axis;     ///< of a pipe, two points or more
  double radius_m = 0;        ///< of a pipe
  double low_m = 0, high_m = 0;  ///< heights that it lies between
};
const char* name_of(CodeShape::Kind kind);

/// Of a target's object that is drawn by its points.
constexpr size_t kFewestDrawnPoints = 20;

/// From which side a door opens, seen from outside; its hinge is measured first.
enum class Hinge { kUnknown, kLeft, kRight };

/// What the codes of some points say together.
struct CodedObject {
  std::string name;                ///< that of the code and of its first point: "window 122"
  CodeRow row;                     ///< of its (first) code
  std::vector<CodedPoint> points;  ///< in the list's order
  CodeShape shape;
  Hinge hinge = Hinge::kUnknown;
};

struct CodedObjects {
  Vec3 origin;  ///< whole metres; shapes are relative to it
  std::vector<CodedObject> objects;
  std::vector<CodeWarning> warnings;  ///< in the order of their lines
};

}  // namespace jalon
