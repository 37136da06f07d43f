// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/field.h"
#include "base/json_cursor.h"
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

/// The JSON of a file, walked through and never held as values: 16 MiB of them would take a gibibyte. Whatever is not
/// as asked for is Error(kFormat) with path and byte, as is a file above 16 MiB.
class JsonFile : public JsonListener {
 public:
  JsonFile(const ByteSource& source, Task& task);
  JsonCursor cursor() const { return {text_, *this}; }
  void refuse(uint64_t byte, const char* expected) const override;
  void tick() const override { task_.checkpoint(0); }

 private:
  const ByteSource& source_;
  Task& task_;
  std::string text_;
};
/// Error(kUnsupported) of points or hierarchies that are compressed, Error(kFormat) of what cannot be.
Index read_index(const ByteSource& source, Task& task);

}  // namespace jalon::ept
