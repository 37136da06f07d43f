// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/files/atomic_file.h"
#include "formats/files/system_file.h"

namespace jalon::ept {

constexpr const char* kIndexFile = "ept.json";
constexpr const char* kDataFolder = "ept-data";
constexpr const char* kHierarchyFolder = "ept-hierarchy";

/// The folder of a data set while it is written: all files in a private folder inside, moved to their places by
/// commit(), the index last. Without it, or where it fails, what was there before is there again, and a folder that
/// was made is gone. Errors are Error(kIo) with path and cause.
class DataSet {
 public:
  /// index: the path of its ept.json; Error(kInvalidArgument) for any other name.
  explicit DataSet(const std::string& index);
  ~DataSet();
  DataSet(const DataSet&) = delete;
  DataSet& operator=(const DataSet&) = delete;

  /// A file of one of the two folders; from any thread.
  void write(const char* folder, const std::string& name, const void* data, size_t bytes) const;
  void commit(std::string_view index);

 private:
  using Path = std::filesystem::path;
  void take_private_folder();
  void make_folder(const Path& path);
  void move(const Path& from, const Path& to);
  void move_away(const Path& old, const char* to);
  void undo() noexcept;

  Path index_path_, folder_, private_;
  bool made_folder_ = false;
  FileHandle lock_ = kNoFile;
  std::optional<AtomicFile> index_;
  std::vector<std::pair<Path, Path>> moved_;  ///< in order, to be undone
};

}  // namespace jalon::ept
