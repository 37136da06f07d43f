// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/files/atomic_file.h"
#include "formats/files/endian.h"
#include "formats/files/number_text.h"
#include "formats/files/utf8.h"
#include "formats/stl/layout.h"
#include "formats/stl/stl.h"
#include "model/chords.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

constexpr size_t kGrain = size_t{1} << 13;
constexpr size_t kBatch = 16 * kGrain;
constexpr double kFarAway_m = 4096;  // from here on float32 steps by half a millimetre and more

/// The triangles of faces, then those of the mesh, each with its solid (part).
struct Triangles {
  std::vector<std::array<uint32_t, 3>> corners;
  std::vector<uint32_t> parts;
};

Triangles all_triangles(const Model& model, Task& task) {
  Triangles out;
  for (size_t f = 0; f < model.faces.size(); ++f) {
    task.checkpoint(static_cast<double>(f) / static_cast<double>(model.faces.size()));
    for (const auto& triangle : triangles_of_face(model, model.faces[f])) {
      out.corners.push_back(triangle);
      out.parts.push_back(model.faces[f].part);
    }
  }
  const bool by_part = is_mesh_by_part(model);
  for (const uint32_t t : loose_triangles(model)) {
    out.corners.push_back(model.triangles[t]);
    out.parts.push_back(by_part ? model.triangle_faces[t] : kNoPart);
  }
  return out;
}

Vec3 normal_of_triangle(const Model& model, const std::array<uint32_t, 3>& t) {
  const Vec3& a = model.vertices[t[0]];
  return normalized(cross(model.vertices[t[1]] - a, model.vertices[t[2]] - a));
}

// Whole metres to take off, so that float32 holds the rest; zero where the coordinates are small as they are.
Vec3 shift_of(const Model& model, const Triangles& triangles) {
  Box3 box;
  for (const auto& t : triangles.corners)
    for (const uint32_t v : t) box.add(model.vertices[v]);
  if (box.empty()) return {};
  bool far = false;
  for (int k = 0; k < 3; ++k)
    far = far || std::max(std::fabs(box.min[k]), std::fabs(box.max[k])) > kFarAway_m;
  return far ? Vec3{std::floor(box.min.x), std::floor(box.min.y), std::floor(box.min.z)} : Vec3{};
}

std::string header_text(const Vec3& shift) {
  std::string head = stl::kShiftWord;
  for (int k = 0; k < 3; ++k) head += " " + text_of(shift[k]);
  return head;
}

void write_binary(AtomicFile& file, const Model& model, const Triangles& triangles, Task& task) {
  if (triangles.corners.size() > 0xFFFFFFFFu)
    fail(Status::kLimit, "an STL file holds at most 2^32 triangles");
  Vec3 shift = shift_of(model, triangles);
  std::string head = header_text(shift);
  if (head.size() > stl::kHeaderBytes) head = header_text(shift = {});  // far beyond any map
  head.resize(stl::kHeaderBytes, ' ');
  file.write(head);
  char count[4];
  store<uint32_t, std::endian::little>(count, static_cast<uint32_t>(triangles.corners.size()));
  file.write(count, sizeof count);
  const size_t n = triangles.corners.size();
  write_in_batches(n, kBatch, kGrain, file, task, [&](size_t begin, size_t end, std::string& out) {
    char record[stl::kRecordBytes] = {};
    const auto put = [&](size_t at, const Vec3& v) {
      for (int k = 0; k < 3; ++k)
        store<float, std::endian::little>(record + at + 4 * static_cast<size_t>(k),
                                          static_cast<float>(v[k]));
    };
    for (size_t i = begin; i < end; ++i) {
      put(0, normal_of_triangle(model, triangles.corners[i]));
      for (size_t k = 0; k < 3; ++k)
        put(12 * (k + 1), model.vertices[triangles.corners[i][k]] - shift);
      out.append(record, sizeof record);
    }
  });
}

// A solid a part, coordinates exactly as they are.
void write_ascii(AtomicFile& file, const Model& model, const Triangles& triangles, Task& task) {
  const auto name = [&](uint32_t part) {
    return part < model.parts.size() ? name_from_file(model.parts[part].name, "part")
                                     : std::string("mesh");
  };
  const size_t n = triangles.corners.size();
  const auto vector = [](std::string& out, const Vec3& v) {
    for (int k = 0; k < 3; ++k) {
      out += ' ';
      append_number(out, v[k]);
    }
    out += '\n';
  };
  if (n == 0) file.write("solid model\nendsolid model\n");
  write_in_batches(n, kBatch, kGrain, file, task, [&](size_t begin, size_t end, std::string& out) {
    for (size_t i = begin; i < end; ++i) {
      const uint32_t part = triangles.parts[i];
      if (i == 0 || triangles.parts[i - 1] != part)
        out.append("solid ").append(name(part)).append("\n");
      out += "facet normal";
      vector(out, normal_of_triangle(model, triangles.corners[i]));
      out += "outer loop\n";
      for (const uint32_t v : triangles.corners[i]) {
        out += "vertex";
        vector(out, model.vertices[v]);
      }
      out += "endloop\nendfacet\n";
      if (i + 1 == n || triangles.parts[i + 1] != part)
        out.append("endsolid ").append(name(part)).append("\n");
    }
  });
}

}  // namespace

void write_stl(const Model& given, const std::string& path, const WriteSettings& settings,
               Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing STL");
  validate(given);
  const Model chords = has_arcs(given) ? with_chords(given, settings.chord_error_m) : Model{};
  const Model& model = chords.vertices.empty() ? given : chords;
  Triangles triangles;
  {
    ProgressSpan part(task, 0, 0.4);
    triangles = all_triangles(model, task);
  }
  ProgressSpan part(task, 0.4, 1);
  AtomicFile file(path);
  if (settings.stl_format == StlForm::kAscii) write_ascii(file, model, triangles, task);
  else write_binary(file, model, triangles, task);
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
