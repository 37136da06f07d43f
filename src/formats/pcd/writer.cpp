// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/text_number.h"
#include "formats/files/atomic_file.h"
#include "formats/files/endian.h"
#include "formats/files/normal_columns.h"
#include "formats/files/number_text.h"
#include "formats/files/utf8.h"
#include "formats/pcd/pcd.h"
#include "geometry/rotation.h"

namespace jalon {

namespace {

constexpr size_t kPcdWriterGrain = size_t{1} << 14;
constexpr size_t kPcdBatch = 16 * kPcdWriterGrain;
constexpr const char* kPcdColours[] = {"red", "green", "blue"};

bool has_packable_colour(const Cloud& cloud) {
  for (const char* name : kPcdColours) {
    const Column* column = cloud.fields.find(name);
    if (column == nullptr || column->info().type != ElementType::kUint8 ||
        column->info().components != 1)
      return false;
  }
  return true;
}

bool is_colour(const FieldInfo& info) {
  for (const char* name : kPcdColours)
    if (info.name == name) return true;
  return false;
}

char letter_of(ElementType type) {
  if (is_floating(type)) return 'F';
  return static_cast<int32_t>(type) % 2 == 1 ? 'I' : 'U';  // the numbers of jalon/types.h
}

/// The lines FIELDS, SIZE, TYPE and COUNT.
struct PcdFields {
  std::string names = "FIELDS", sizes = "\nSIZE", types = "\nTYPE", counts = "\nCOUNT";
  void add(std::string_view name, ElementType type, uint32_t count = 1) {
    names.append(" ").append(name);
    sizes += " " + std::to_string(size_of(type));
    types += std::string(" ") + letter_of(type);
    counts += " " + std::to_string(count);
  }
};

// Names hold no blanks or control characters.
std::string pcd_name(const std::string& wanted, UniqueNames& unique) {
  std::string name = wanted.empty() ? "field" : wanted;
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7f) c = '_';
  if (name == "_") name = "field";  // which would be padding
  return unique.add(name);
}

std::string viewpoint_of(const Cloud& cloud) {
  if (cloud.stations.size() != 1 || !cloud.stations[0].has_pose) return "0 0 0 1 0 0 0";
  const auto& m = cloud.stations[0].pose.m;
  const Quaternion q = quaternion_of({{m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}});
  std::string out;
  for (const double value : {m[3], m[7], m[11], q.w, q.x, q.y, q.z})
    out += (out.empty() ? "" : " ") + text_of(value);
  return out;
}

std::string pcd_header(const Cloud& cloud, bool packed) {
  PcdFields fields;
  UniqueNames unique;
  for (const char* name : {"x", "y", "z"}) fields.add(unique.add(name), ElementType::kFloat64);
  if (packed) fields.add(unique.add("rgb"), ElementType::kUint32);
  for (const char* name : {"normal_x", "normal_y", "normal_z"}) unique.add(name);
  for (const ColumnPtr& column : cloud.fields) {
    const FieldInfo& info = column->info();
    if (packed && is_colour(info)) continue;
    if (is_normal(info))
      for (const char* name : {"normal_x", "normal_y", "normal_z"}) fields.add(name, info.type);
    else fields.add(pcd_name(info.name, unique), info.type, info.components);
  }
  const std::string& crs = cloud.crs;
  const std::string count = std::to_string(cloud.size());
  std::string out = "# .PCD v0.7 - Point Cloud Data file format\n";
  if (!crs.empty() && crs.find_first_of("\r\n") == std::string::npos)
    out.append("# crs: ").append(crs).append("\n");
  out.append("VERSION 0.7\n").append(fields.names).append(fields.sizes).append(fields.types);
  out.append(fields.counts).append("\nWIDTH ").append(count).append("\nHEIGHT 1\nVIEWPOINT ");
  return out.append(viewpoint_of(cloud))
      .append("\nPOINTS ")
      .append(count)
      .append("\nDATA binary\n");
}

void append_records(const Cloud& cloud, bool packed, size_t begin, size_t end, std::string& out) {
  const uint8_t* colours[3] = {};
  for (size_t k = 0; k < 3 && packed; ++k)
    colours[k] = static_cast<const uint8_t*>(cloud.fields.find(kPcdColours[k])->raw());
  for (size_t i = begin; i < end; ++i) {
    for (size_t k = 0; k < 3; ++k) append_stored(out, cloud.xyz()[3 * i + k]);
    if (packed)
      append_stored(out, uint32_t{colours[0][i]} << 16 | uint32_t{colours[1][i]} << 8 |
                             uint32_t{colours[2][i]});
    for (const ColumnPtr& column : cloud.fields) {
      if (packed && is_colour(column->info())) continue;
      const uint32_t components = column->info().components;
      visit(column->info().type, [&](auto zero) {
        using T = decltype(zero);
        const T* from = static_cast<const T*>(column->raw()) + i * components;
        for (uint32_t c = 0; c < components; ++c) append_stored(out, from[c]);
      });
    }
  }
}

}  // namespace

void write_pcd(const Cloud& cloud, const std::string& path, const WriteSettings&, Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing PCD");
  const bool packed = has_packable_colour(cloud);
  AtomicFile file(path);
  file.write(pcd_header(cloud, packed));
  write_in_batches(cloud.size(), kPcdBatch, kPcdWriterGrain, file, task,
                   [&](size_t begin, size_t end, std::string& out) {
                     append_records(cloud, packed, begin, end, out);
                   });
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
