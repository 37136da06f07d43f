// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "formats/city/text.h"
#include "unit/formats/fixtures.h"

namespace jalon::test {

/// A JSON text in a file of its own, and the piece that cursors walk through.
class JsonFile {
 public:
  explicit JsonFile(std::string text)
      : text_(std::move(text)), source_(spilled(folder_.file("piece.json"), text_)) {}

  const std::string& text() const { return text_; }
  const ByteSource& source() const { return source_; }
  Task& task() { return task_; }
  city::Piece piece() { return {source_, task_, text_}; }

 private:
  static std::string spilled(const std::string& path, const std::string& bytes) {
    spill(path, bytes);
    return path;
  }

  Folder folder_;
  std::string text_;
  ByteSource source_;
  Task task_;
};

}  // namespace jalon::test
