// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/numbers.h"
#include "segment/codes/code_list.h"

namespace jalon {

/// A surveyed point as the notes tell it.
struct NotedPoint {
  std::string id, code;  ///< "300.2"
  size_t line = 0;
  Vec3 place;
};

/// A coded object as the notes tell it; what its shape lacks is empty or NaN.
struct NotedObject {
  std::string name, kind, geometry, shape, hinge;
  int64_t code = 0, class_code = 0;
  uint32_t label = 0;  ///< of its segment, 0: none
  uint64_t points = 0;
  std::vector<NotedPoint> surveyed;
  std::vector<Vec3> outline;  ///< of a prism at its upper height, of an opening in space
  std::vector<Vec3> axis;
  double radius_m = kNaN, low_m = kNaN, high_m = kNaN;
};

struct NotedClass {
  int64_t class_code = 0;
  uint64_t points = 0;
};

/// What coded_notes() wrote.
struct CodedNotes {
  std::string method;
  std::vector<NotedClass> classes;
  std::vector<NotedObject> objects;
  std::vector<CodeWarning> warnings;
};

/// Reads it back; "" gives none. Notes come with segmentations from files too: Error(kFormat) where anything is
/// missing or no number.
CodedNotes read_coded_notes(std::string_view json);

}  // namespace jalon
