// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "model/model.h"

// OBJ knows triangles, polygons without holes and lines. What else a model has stands in comments "#: ...", which other
// programs pass over; with them a file comes back as the model it was:
//
//   #: crs EPSG:2154                            of the coordinates
//   #: part 3 of 1 class window evidence measured width 1.2 height 2.1 depth 0.2 name window 5
//   #: face part 2 id 5 class 1 sigma 0.003      the next line "l" is its outline
//   #: hole part 3                               the next "l" is a hole of it
//   #: solid part 2 first 0 count 6              faces that enclose a volume
//   #: mesh                                      triangles before this line are those of the faces
namespace jalon::obj {

inline constexpr std::string_view kNote = "#:";

/// Nothing when the CRS is not known, or longer than a line.
void append_crs_note(std::string& out, const std::string& crs);
void append_part_note(std::string& out, const Model& model, uint32_t part);
void append_face_note(std::string& out, const Face& face);
void append_hole_note(std::string& out, const Ring& ring);
void append_solid_note(std::string& out, const Solid& solid);

/// Builds the model that the notes and lines of a file tell.
class Notes {
 public:
  /// The text behind "#:"; false when it is none that we wrote.
  bool read(std::string_view text, size_t triangles_so_far);
  /// A line through these vertices: a ring, when a note announced one.
  void line(std::span<const uint32_t> vertices);

  bool wants_ring() const { return wants_ring_; }
  bool has_faces() const { return !faces_.empty(); }
  size_t own_triangles(size_t all) const { return mesh_from_ == kNone ? all : mesh_from_; }
  /// Puts parts, faces and solids into the model; false when they do not fit together.
  bool build(Model& model);

 private:
  static constexpr size_t kNone = ~size_t{0};
  bool read_part(std::string_view text);
  std::string crs_;
  std::vector<Part> parts_;
  std::vector<Face> faces_;
  std::vector<Ring> rings_;
  std::vector<uint32_t> corners_;
  std::vector<Solid> solids_;
  size_t mesh_from_ = kNone;
  uint32_t hole_part_ = kNoPart;
  bool wants_ring_ = false;
};

}  // namespace jalon::obj
