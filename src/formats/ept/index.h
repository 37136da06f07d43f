// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/field.h"
#include "base/json_reader.h"
#include "base/task.h"
#include "formats/files/byte_source.h"
#include "formats/files/told_stations.h"
#include "geometry/vec.h"

namespace jalon::ept {

/// What an ept.json tells of the files beside it.
struct Index {
  struct Axis {
    ElementType type = ElementType::kInt32;
    size_t offset = 0;
    double scale = 1, shift = 0;
  };
  struct Member {
    std::string field;
    ElementType type = ElementType::kUint8;
    uint32_t components = 1;
    size_t offset = 0;
  };
  Vec3 low;  ///< of the cube
  double edge = 1;
  double spacing = 1;  ///< of the points of level 0; half as wide each level down
  std::array<Axis, 3> axes;
  std::vector<Member> members;
  size_t record_bytes = 0;
  std::string crs;
  ToldStations stations;
};

/// The JSON of a file; Error(kFormat) where it is none or above 16 MiB.
std::vector<JsonValue> json_of(const ByteSource& source);
/// Error(kUnsupported) of points or hierarchies that are compressed, Error(kFormat) of what cannot be.
Index read_index(const ByteSource& source, Task& task);

}  // namespace jalon::ept
