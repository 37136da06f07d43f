// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/files/atomic_file.h"
#include "formats/files/endian.h"
#include "formats/files/normal_columns.h"
#include "formats/files/number_text.h"
#include "formats/files/told_stations.h"
#include "formats/files/utf8.h"
#include "formats/ply/ply.h"
#include "model/chords.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

constexpr size_t kCommentBytes = size_t{1} << 16;  // of a line: more stations take several
constexpr size_t kWriterGrain = size_t{1} << 12;   // items a chunk, of some 100 bytes each
constexpr size_t kBatch = 16 * kWriterGrain;       // in memory at a time
constexpr size_t kRowsTogether = 1024;  // of some 50 bytes: they stay in a cache of 256 KiB

const char* type_word(ElementType type) {
  switch (type) {
    case ElementType::kInt8:
      return "char";
    case ElementType::kUint8:
      return "uchar";
    case ElementType::kInt16:
      return "short";
    case ElementType::kUint16:
      return "ushort";
    case ElementType::kInt32:
      return "int";
    case ElementType::kUint32:
      return "uint";
    case ElementType::kFloat32:
      return "float";
    default:
      return "double";
  }
}

// PLY knows no integers of 64 bits: doubles hold those up to 2^53.
void require_exact(const Column& column) {
  constexpr int64_t kLimit = int64_t{1} << 53;
  const auto refuse = [&](size_t i) {
    fail(Status::kUnsupported, "item %zu of field \"%s\" is beyond 2^53, which PLY cannot hold",
         i / column.info().components, column.info().name.c_str());
  };
  if (column.info().type == ElementType::kInt64) {
    const auto values = column.values<int64_t>();
    for (size_t i = 0; i < values.size(); ++i)
      if (values[i] > kLimit || values[i] < -kLimit) refuse(i);
  } else if (column.info().type == ElementType::kUint64) {
    const auto values = column.values<uint64_t>();
    for (size_t i = 0; i < values.size(); ++i)
      if (values[i] > static_cast<uint64_t>(kLimit)) refuse(i);
  }
}

// Property names hold no blanks or control characters.
std::string property_name(std::string_view wanted, UniqueNames& unique) {
  std::string name(wanted);
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7f) c = '_';
  if (name.empty()) name.append("field");
  return unique.add(name);
}

std::string header_text(const Cloud& cloud, PlyForm form) {
  std::string out = "ply\nformat ";
  out += form == PlyForm::kAscii       ? "ascii"
         : form == PlyForm::kBigEndian ? "binary_big_endian"
                                       : "binary_little_endian";
  out += " 1.0\ncomment Jalon\n";
  const std::string& crs = cloud.crs;
  if (!crs.empty() && crs.find_first_of("\r\n") == std::string::npos)
    out.append("comment crs ").append(crs).append("\n");
  for (const std::string& text : station_texts(cloud, "", {1, 1, 1}, kCommentBytes))
    out.append("comment stations ").append(text).append("\n");
  out.append("element vertex ").append(std::to_string(cloud.size()));
  out += "\nproperty double x\nproperty double y\nproperty double z\n";
  UniqueNames unique;
  reserve_point_names(cloud.fields, unique);
  for (const ColumnPtr& column : cloud.fields) {
    const FieldInfo& field = column->info();
    require_exact(*column);
    for (uint32_t c = 0; c < field.components; ++c) {
      const std::string name = field.components == 1 ? field.name : numbered(field.name, c);
      out.append("property ")
          .append(type_word(field.type))
          .append(" ")
          .append(is_normal(field) ? kNormalColumns[c] : property_name(name, unique))
          .append("\n");
    }
  }
  return out + "end_header\n";
}

// Item `from[k * step]` of the rows k, each at `to + k * row_bytes`.
template <std::endian Order, class Stored, class T>
void store_items(const T* from, size_t step, size_t rows, char* to, size_t row_bytes) {
  for (size_t k = 0; k < rows; ++k)
    store<Stored, Order>(to + k * row_bytes, static_cast<Stored>(from[k * step]));
}

// Column by column, in blocks of rows that stay in the cache: the type is asked once a block, not once an item.
template <std::endian Order>
void append_vertices(const Cloud& cloud, size_t begin, size_t end, std::string& out) {
  size_t row_bytes = 3 * sizeof(double);
  for (const ColumnPtr& column : cloud.fields)
    row_bytes += column->info().components * size_of(column->info().type);
  size_t at = out.size();
  out.resize(at + (end - begin) * row_bytes);
  for (size_t first = begin; first < end; first += kRowsTogether) {
    const size_t rows = std::min(kRowsTogether, end - first);
    char* to = out.data() + at;
    for (size_t k = 0; k < 3; ++k, to += sizeof(double))
      store_items<Order, double>(cloud.xyz().data() + 3 * first + k, 3, rows, to, row_bytes);
    for (const ColumnPtr& column : cloud.fields) {
      const size_t components = column->info().components;
      visit(column->info().type, [&](auto zero) {
        using T = decltype(zero);
        using Stored = std::conditional_t<sizeof(T) == 8, double, T>;
        const T* from = static_cast<const T*>(column->raw()) + first * components;
        for (size_t c = 0; c < components; ++c, to += sizeof(Stored))
          store_items<Order, Stored>(from + c, components, rows, to, row_bytes);
      });
    }
    at += rows * row_bytes;
  }
}

void append_ascii(const Cloud& cloud, size_t begin, size_t end, int decimals, std::string& out) {
  for (size_t i = begin; i < end; ++i) {
    for (size_t k = 0; k < 3; ++k) {
      if (k != 0) out += ' ';
      if (decimals < 0) append_number(out, cloud.xyz()[3 * i + k]);
      else out += text_of(cloud.xyz()[3 * i + k], decimals);
    }
    for (const ColumnPtr& column : cloud.fields) append_item(out, *column, i, ' ');
    out += '\n';
  }
}

}  // namespace

void write_ply(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing PLY");
  const PlyForm form = settings.ply_format;
  const int decimals = settings.decimals;
  const std::string header = header_text(cloud, form);
  AtomicFile file(path);
  file.write(header);
  write_in_batches(cloud.size(), kBatch, kWriterGrain, file, task,
                   [&](size_t begin, size_t end, std::string& out) {
                     if (form == PlyForm::kLittleEndian)
                       append_vertices<std::endian::little>(cloud, begin, end, out);
                     if (form == PlyForm::kBigEndian)
                       append_vertices<std::endian::big>(cloud, begin, end, out);
                     if (form == PlyForm::kAscii) append_ascii(cloud, begin, end, decimals, out);
                   });
  task.checkpoint(1);
  file.commit();
}

namespace {

struct Mesh {
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint32_t> ids;
};

Mesh mesh_of(const Model& model, Task& task) {
  Mesh mesh;
  for (const uint32_t t : loose_triangles(model)) {
    mesh.triangles.push_back(model.triangles[t]);
    mesh.ids.push_back(model.triangle_faces[t]);
  }
  for (const Face& face : model.faces) {
    task.checkpoint(0.3);
    for (const auto& triangle : triangles_of_face(model, face)) {
      mesh.triangles.push_back(triangle);
      mesh.ids.push_back(face.id);
    }
  }
  return mesh;
}

}  // namespace

void write_ply_model(const Model& given, const std::string& path, const WriteSettings& settings,
                     Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing PLY");
  validate(given);
  const Model chords = has_arcs(given) ? with_chords(given, settings.chord_error_m) : Model{};
  const Model& model = chords.vertices.empty() ? given : chords;
  const Mesh mesh = mesh_of(model, task);
  const auto& triangles = mesh.triangles;
  const PlyForm form = settings.ply_format;
  std::string head = "ply\nformat ";
  head += form == PlyForm::kAscii       ? "ascii"
          : form == PlyForm::kBigEndian ? "binary_big_endian"
                                        : "binary_little_endian";
  head.append(" 1.0\ncomment Jalon\nelement vertex ").append(std::to_string(model.vertices.size()));
  head.append("\nproperty double x\nproperty double y\nproperty double z\nelement face ")
      .append(std::to_string(triangles.size()));
  head += "\nproperty list uchar uint vertex_indices\nproperty uint face_id\nend_header\n";
  AtomicFile file(path);
  file.write(head);
  const auto put = [&](std::string& out, auto value, char after) {
    if (form == PlyForm::kLittleEndian) return append_stored<std::endian::little>(out, value);
    if (form == PlyForm::kBigEndian) return append_stored<std::endian::big>(out, value);
    append_number(out, value);
    out += after;
  };
  write_in_batches(model.vertices.size(), kBatch, kWriterGrain, file, task,
                   [&](size_t begin, size_t end, std::string& out) {
                     for (size_t i = begin; i < end; ++i)
                       for (int k = 0; k < 3; ++k)
                         put(out, model.vertices[i][k], k == 2 ? '\n' : ' ');
                   });
  write_in_batches(triangles.size(), kBatch, kWriterGrain, file, task,
                   [&](size_t begin, size_t end, std::string& out) {
                     for (size_t i = begin; i < end; ++i) {
                       put(out, uint8_t{3}, ' ');
                       for (const uint32_t corner : triangles[i]) put(out, corner, ' ');
                       put(out, mesh.ids[i], '\n');
                     }
                   });
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
