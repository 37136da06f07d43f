// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/system/folder_lock.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace jalon::cli {

bool FolderLock::take(const std::filesystem::path& folder, bool is_new) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return false;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || (is_new && errno != EWOULDBLOCK)) {
    folder_ = folder;
    handle_ = descriptor;
    return true;
  }
  ::close(descriptor);
  return false;
}

void FolderLock::remove_and_release() {
  std::error_code ignored;
  if (handle_ >= 0) std::filesystem::remove_all(folder_, ignored);
  release();
}

void FolderLock::release() {
  if (handle_ >= 0) ::close(static_cast<int>(handle_));
  handle_ = -1;
}

}  // namespace jalon::cli
