// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/system/folder_lock.h"

namespace jalon::cli {

/// Results appear in a folder together: they are written into a private folder inside it and renamed by commit(). When
/// anything fails before, the private folder goes and what was in the folder stays as it was. The one that a killed run
/// left is taken by the next.
class OutputFolder {
 public:
  explicit OutputFolder(const std::string& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write the file of this name for now.
  std::string path(const std::string& name);
  /// The same for a file that may come to nothing: path() takes it when it is there.
  std::string unlisted_path(const std::string& name) const;
  void commit();

 private:
  std::filesystem::path folder_, private_;
  std::vector<std::string> names_;
  FolderLock lock_;
  bool created_ = false;
};

}  // namespace jalon::cli
