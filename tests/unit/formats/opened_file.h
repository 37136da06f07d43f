// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "formats/files/byte_source.h"
#include "unit/formats/fixtures.h"

namespace jalon::test {

/// A file of these bytes, open for a reader, in a folder of its own.
class OpenedFile {
 public:
  explicit OpenedFile(const std::string& bytes, const std::string& name = "a")
      : source_(kept(folder_.file(name), bytes)) {}

  operator const ByteSource&() const { return source_; }
  const std::string& path() const { return source_.path(); }

 private:
  static std::string kept(const std::string& path, const std::string& bytes) {
    spill(path, bytes);
    return path;
  }

  Folder folder_;
  ByteSource source_;
};

inline bool has_text(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace jalon::test
