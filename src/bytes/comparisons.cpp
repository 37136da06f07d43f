// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/comparisons.h"

#include <algorithm>

#include "bytes/clouds.h"
#include "bytes/tables.h"

namespace jalon {

namespace {

constexpr auto kF64 = ElementType::kFloat64;

// Those of jalon/comparer.h that are read by their names: regions, diagnosis, reports and levels of detection. Of
// "preview" with angles there is no distance.
constexpr KnownColumn kComparedColumns[] = {
    {"distance", kF64},
    {"plane_angle", kF64},
    {"status", ElementType::kUint8, 1, true},
    {"nearest", ElementType::kUint32},
    {"difference_x", kF64},
    {"difference_y", kF64},
    {"difference_z", kF64},
    {"sampling_error", ElementType::kFloat32},
    {"reference_spacing", ElementType::kFloat32},
    {"recovered", ElementType::kUint8},
    {"height", kF64},
    {"shape_residual", kF64},
    {"face", ElementType::kUint32},
    {"triangle", ElementType::kUint32},
    {"part", ElementType::kUint32},
    {"side", ElementType::kUint8},
    {"within_tolerance", ElementType::kUint8},
    {"lod", kF64},
    {"significant", ElementType::kUint8},
    {"normal", kF64, 3},
    {"normal_radius", kF64},
    {"count_reference", ElementType::kUint32},
    {"count_compared", ElementType::kUint32},
    {"spread_reference", kF64},
    {"spread_compared", kF64},
    {"zone", ElementType::kUint32},
    {"sigma", kF64},
    {"reference_status", ElementType::kUint8},
    {"compared_status", ElementType::kUint8},
    {"column", ElementType::kUint32},
    {"row", ElementType::kUint32},
    {"reference_points", ElementType::kUint32},
    {"compared_points", ElementType::kUint32},
};

void require_whole_comparison(const ByteReader& reader, const Comparison& comparison) {
  require_known(reader, comparison.points, kComparedColumns);
  require_rows(reader, comparison.points, "columns", comparison.cloud->size());
  require_rows(reader, comparison.summary, "columns of the summary", 1);
  const auto has = [&](const char* name) { return comparison.points.find(name) != nullptr; };
  if (has("difference_x") != has("difference_y") || has("difference_x") != has("difference_z"))
    reader.refuse("the differences are not told along all three axes");
  const auto status = comparison.points.require("status").values<uint8_t>();
  if (std::any_of(status.begin(), status.end(), [](uint8_t s) { return s >= kCompareStatuses; }))
    reader.refuse("a point has a status that is none");
}

}  // namespace

void write_comparison(ByteWriter& writer, const Comparison& comparison) {
  write_cloud(writer, *comparison.cloud);
  write_table(writer, comparison.points);
  write_table(writer, comparison.summary);
  write_table(writer, comparison.parts);
  writer.item(comparison.parameters_json);
}

Comparison read_comparison(ByteReader& reader, Task& task) {
  Comparison out;
  out.cloud = std::make_shared<const Cloud>(read_cloud(reader, task));
  out.points = read_table(reader, task);
  out.summary = read_table(reader, task);
  out.parts = read_table(reader, task);
  reader.item(out.parameters_json);
  require_whole_comparison(reader, out);
  return out;
}

}  // namespace jalon
