// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/field.h"
#include "formats/files/byte_source.h"

namespace jalon::ply {

enum class Encoding { kAscii, kLittle, kBig };

struct Property {
  std::string name;
  ElementType type = ElementType::kFloat32;  ///< of a list: of its items
  bool list = false;
  ElementType count_type = ElementType::kUint8;
};

struct Element {
  std::string name;
  uint64_t count = 0;
  std::vector<Property> properties;
  bool has_list() const;
  /// Bytes of one item, a list counting with its length alone: exact without lists, a lower bound
  /// with them.
  uint64_t least_bytes(Encoding encoding) const;
};

struct Header {
  Encoding encoding = Encoding::kAscii;
  std::vector<Element> elements;
  uint64_t data_offset = 0;
  std::string crs;
  std::vector<std::string> stations;  ///< texts of told_stations.h
  bool by_cloudcompare = false;       ///< names its fields "scalar_..."
};

/// Refuses counts that the file has no room for.
Header read_header(const ByteSource& source);

}  // namespace jalon::ply
