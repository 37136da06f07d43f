// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/json_cursor.h"
#include "base/task.h"
#include "formats/files/byte_source.h"

namespace jalon::city {

/// A piece of the text of a file; cursors on it refuse with the file's name and the byte in the file, and look at the
/// task.
class Piece : public JsonListener {
 public:
  Piece() = default;
  Piece(const ByteSource& source, Task& task, std::string_view text, uint64_t offset = 0)
      : source_(&source), task_(&task), text_(text), offset_(offset) {}

  bool empty() const { return text_.empty(); }
  uint64_t offset() const { return offset_; }
  JsonCursor cursor() const { return {text_, *this}; }
  /// The value at a cursor of this piece.
  Piece value(JsonCursor& cursor) const {
    cursor.kind();  // moves past the blanks
    const uint64_t at = cursor.byte();
    return {*source_, *task_, cursor.skip(), offset_ + at};
  }

  void refuse(uint64_t byte, const char* expected) const override {
    source_->refuse(offset_ + byte, "no CityJSON: %s was expected", expected);
  }
  void tick() const override { task_->checkpoint(0.5); }

 private:
  const ByteSource* source_ = nullptr;
  Task* task_ = nullptr;
  std::string_view text_;
  uint64_t offset_ = 0;
};

/// The top level of a file.
struct FileText {
  Piece transform, metadata, objects, vertices;
};
/// Refuses what is no CityJSON 1.0, 1.1 or 2.0.
FileText read_file_text(const ByteSource& source, Task& task, std::string_view text);

/// A geometry of an object.
struct GeometryText {
  std::string type;
  double lod = -1;  ///< level of detail; -1: none that is a number
  Piece boundaries, surfaces, values;
  int depth = 0;             ///< lists above the surfaces: 0 MultiSurface, 1 Solid, 2 MultiSolid
  bool has_surfaces = true;  ///< false: points and lines
};
/// list: the array that the cursor walks through.
GeometryText read_geometry_text(const Piece& list, JsonCursor& cursor);
/// Refuses types that are not known, or not supported, and fills depth and has_surfaces.
void classify(GeometryText& geometry, const ByteSource& source, const Piece& list);

}  // namespace jalon::city
