// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/atomic_file.h"
#include "formats/files/number_text.h"
#include "formats/files/utf8.h"
#include "formats/obj/notes.h"
#include "formats/obj/obj.h"
#include "model/chords.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

constexpr size_t kGrain = size_t{1} << 13;
constexpr size_t kBatch = 16 * kGrain;

// A group's name is one word.
std::string word_of(const std::string& name, const std::string& fallback) {
  std::string out;
  for (const char c : name)
    out += static_cast<unsigned char>(c) <= 0x20 || c == 0x7f || c == '#' || c == '\\' ? '_' : c;
  return out.empty() ? fallback : out;
}

void append_corner(std::string& out, uint32_t vertex) {
  out += ' ';
  append_number(out, uint64_t{vertex} + 1);
}

bool is_convex(const Model& model, const Face& face) {
  const Ring& ring = model.rings[face.first_ring];
  const PlaneAxes axes = axes_of(normal_of(model, face));
  const auto corner = [&](uint64_t i) {
    return model.vertices[model.corners[ring.first + i % ring.count]];
  };
  const Vec3 origin = corner(0);
  for (uint64_t i = 0; i < ring.count; ++i) {
    const Vec2 a = axes.project(corner(i), origin), b = axes.project(corner(i + 1), origin),
               c = axes.project(corner(i + 2), origin);
    if (cross(b - a, c - b) < 0) return false;
  }
  // Turning left everywhere also holds for a star; four corners cannot make one.
  return ring.count <= 4;
}

// A polygon where every viewer draws it rightly, triangles elsewhere, so that openings stay open.
void append_face(std::string& out, const Model& model, const Face& face) {
  const std::string plane = numbered("plane", face.id);
  out.append("g ").append(plane).append("\n");
  if (face.ring_count == 1 && is_convex(model, face)) {
    const Ring& ring = model.rings[face.first_ring];
    out += "f";
    for (uint64_t c = 0; c < ring.count; ++c) append_corner(out, model.corners[ring.first + c]);
    out += "\n";
    return;
  }
  for (const auto& triangle : triangles_of_face(model, face)) {
    out += "f";
    for (const uint32_t corner : triangle) append_corner(out, corner);
    out += "\n";
  }
}

bool has_outline(const Model& model, const Face& face) {
  return face.ring_count > 0 && model.rings[face.first_ring].count >= 3;
}

void append_outlines(std::string& out, const Model& model, const Face& face) {
  for (uint64_t r = 0; r < face.ring_count; ++r) {
    const Ring& ring = model.rings[face.first_ring + r];
    if (ring.count < 3) continue;
    if (r == 0) obj::append_face_note(out, face);
    else obj::append_hole_note(out, ring);
    const std::string name =
        r == 0 ? numbered("outline", face.id) : numbered(numbered("opening", face.id), r);
    out.append("g ").append(name).append("\nl");
    for (uint64_t c = 0; c <= ring.count; ++c)
      append_corner(out, model.corners[ring.first + c % ring.count]);
    out += "\n";
  }
}

// Solids name their faces by their order in the file: those without an outline do not stand there.
void append_solids(std::string& out, const Model& model) {
  std::vector<uint64_t> before{0};
  for (const Face& face : model.faces)
    before.push_back(before.back() + (has_outline(model, face) ? 1 : 0));
  for (Solid solid : model.solids) {
    const uint64_t end = before[solid.first_face + solid.face_count];
    solid.first_face = before[solid.first_face];
    solid.face_count = end - solid.first_face;
    obj::append_solid_note(out, solid);
  }
}

void write_faces(AtomicFile& file, const Model& model, Task& task) {
  std::string text;
  uint32_t part = ~uint32_t{0};
  for (size_t f = 0; f < model.faces.size(); ++f) {
    task.checkpoint(static_cast<double>(f) / static_cast<double>(model.faces.size()));
    const Face& face = model.faces[f];
    if (!has_outline(model, face)) continue;
    if (face.part != part && face.part < model.parts.size()) {
      part = face.part;
      text.append("o ")
          .append(word_of(model.parts[part].name, numbered("part", part)))
          .append("\n");
    }
    append_face(text, model, face);
    file.write(text);
    text.clear();
  }
  if (model.faces.empty()) return;
  text = "o outlines\n";
  for (const Face& face : model.faces)
    if (has_outline(model, face)) append_outlines(text, model, face);
  append_solids(text, model);
  text.append(obj::kNote).append(" mesh\n");
  file.write(text);
}

void write_mesh(AtomicFile& file, const Model& model, Task& task) {
  const std::vector<uint32_t> triangles = loose_triangles(model);
  if (triangles.empty()) return;
  file.write("o mesh\n");
  const bool by_part = is_mesh_by_part(model);
  write_in_batches(
      triangles.size(), kBatch, kBatch, file, task,
      [&](size_t begin, size_t end, std::string& out) {
        for (size_t i = begin; i < end; ++i) {
          const uint32_t id = model.triangle_faces[triangles[i]];
          if (i == 0 || id != model.triangle_faces[triangles[i - 1]]) {
            const std::string number = std::to_string(id);
            out += "g " +
                   (by_part ? word_of(model.parts[id].name, "part_" + number) : "face_" + number) +
                   "\n";
          }
          out += "f";
          for (const uint32_t corner : model.triangles[triangles[i]]) append_corner(out, corner);
          out += "\n";
        }
      });
}

}  // namespace

void write_obj(const Model& given, const std::string& path, const WriteSettings& settings,
               Task& task) {
  ProgressSpan whole(task, 0, 0.99, "writing OBJ");
  validate(given);
  const Model chords = has_arcs(given) ? with_chords(given, settings.chord_error_m) : Model{};
  const Model& model = chords.vertices.empty() ? given : chords;
  AtomicFile file(path);
  std::string head = "# Jalon, coordinates in metres\n";
  if (!model.faces.empty()) {
    obj::append_crs_note(head, model.crs);
    for (uint32_t p = 0; p < model.parts.size(); ++p) obj::append_part_note(head, model, p);
  }
  file.write(head);
  {
    ProgressSpan span(task, 0, 0.4);
    write_in_batches(model.vertices.size(), kBatch, kGrain, file, task,
                     [&](size_t begin, size_t end, std::string& out) {
                       for (size_t i = begin; i < end; ++i) {
                         out += "v";
                         for (int k = 0; k < 3; ++k) {
                           out += ' ';
                           append_number(out, model.vertices[i][k]);
                         }
                         out += '\n';
                       }
                     });
  }
  {
    ProgressSpan span(task, 0.4, 0.7);
    write_faces(file, model, task);
  }
  {
    ProgressSpan span(task, 0.7, 1);
    write_mesh(file, model, task);
  }
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
