// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

namespace jalon::cli {

/// A folder that one run at a time has; the system lets go of it when the process ends, however it ends.
/// folder_lock_posix.cpp (Linux, macOS) or folder_lock_windows.cpp is compiled.
class FolderLock {
 public:
  FolderLock() = default;
  ~FolderLock() { release(); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// False: another run holds it; of an old folder also where the file system knows no locks, and nobody can tell.
  bool take(const std::filesystem::path& folder, bool is_new);
  /// Removes the folder and all that is in it, then lets go of it.
  void remove_and_release();

 private:
  void release();
  std::filesystem::path folder_;
  std::intptr_t handle_ = -1;
};

}  // namespace jalon::cli
