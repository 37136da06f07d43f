// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/json_writer.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/las/plan.h"
#include "formats/settings.h"

namespace jalon::ept {

/// One number of a record: a component of a field.
struct Dimension {
  std::string name;
  ColumnPtr column;
  uint32_t component = 0;
  size_t offset = 0;
};

/// How a point lies in the files of the nodes: X, Y and Z in steps (int32), then the fields in their types.
struct Schema {
  las::Plan steps;
  std::vector<Dimension> dimensions;  ///< behind the coordinates
  size_t record_bytes = 0;
  std::string station;  ///< the dimension that numbers the points' stations, or none
};

/// "signed", "unsigned" or "float".
const char* kind_of(ElementType type);
/// What the field of a dimension of this name is called here.
std::string field_of(const std::string& dimension);
/// Fields of LAS are called as EPT's readers know them (Intensity, GpsTime ...), components of normals NormalX, NormalY
/// and NormalZ, those of others by their number.
Schema make_schema(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                   Task& task);
void put_records(const Schema& schema, const Cloud& cloud, std::span<const uint32_t> points,
                 std::byte* to);
/// The array "schema" of ept.json, with the statistics by which viewers choose their colours.
void add_schema(const Schema& schema, JsonWriter& json, Task& task);

}  // namespace jalon::ept
