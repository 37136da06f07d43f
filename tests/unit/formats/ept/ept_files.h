// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "unit/formats/las/copc_files.h"

namespace jalon::test {

/// A data set of a wall above a ground, in a folder of its own, to be read or damaged.
class EptFolder {
 public:
  explicit EptFolder(const Cloud& cloud) { write(cloud, path()); }
  std::string path() const { return file("ept.json"); }
  std::string file(const std::string& name) const { return folder_.file("set") + "/" + name; }
  /// Replaces the first such text of a file.
  void change(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = slurp(file(name));
    const size_t at = text.find(from);
    REQUIRE_MESSAGE(at != std::string::npos, name, ": ", from);
    spill(file(name), text.replace(at, from.size(), to));
  }

 private:
  Folder folder_;
};

constexpr const char* kRootHierarchy = "ept-hierarchy/0-0-0-0.json";

}  // namespace jalon::test
