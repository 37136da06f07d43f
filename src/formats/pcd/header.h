// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/field.h"
#include "formats/files/byte_source.h"
#include "geometry/vec.h"

namespace jalon::pcd {

enum class Data { kAscii, kBinary, kCompressed };

struct Member {
  std::string name;
  ElementType type = ElementType::kFloat32;
  uint32_t count = 1;
  size_t offset = 0;  ///< in a record
  size_t bytes() const { return size_of(type) * count; }
};

struct Header {
  std::vector<Member> members;
  size_t record_bytes = 0;
  uint64_t width = 0, height = 1, points = 0;
  bool has_pose = false;  ///< a viewpoint that is not the origin, which stands for "unknown"
  Transform pose;
  Data data = Data::kAscii;
  uint64_t data_offset = 0;
  uint64_t data_line = 1;  ///< number of the first line of ASCII data
  std::string crs;         ///< of a comment of our own writer
};

/// Refuses counts that the file has no room for.
Header read_header(const ByteSource& source);

}  // namespace jalon::pcd
