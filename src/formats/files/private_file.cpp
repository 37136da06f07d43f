// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/private_file.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace jalon {

namespace {

constexpr int kNameTries = 1000;  // writers of one target at once
constexpr int kSwept = 16;        // names that are always looked at for leftovers

std::string private_name(const std::string& target, int number) {
  return target + ".jalon" + std::to_string(number) + ".part";
}

/// The name still stands for the file that is open: nobody swept it away before the lock was held.
bool is_still(const std::string& path, int descriptor) {
  struct stat open {};
  struct stat named {};
  return ::fstat(descriptor, &open) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

/// The kernel lets go of a lock when its process ends, however it ends: an unlocked file is a leftover.
void sweep(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat info {};
  if (::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode) &&
      ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_still(path, descriptor))
    ::unlink(path.c_str());
  ::close(descriptor);
}

}  // namespace

PrivateFile open_private_file(const std::string& target) {
  for (int i = 0; i < kSwept; ++i) sweep(private_name(target, i));
  for (int i = 0; i < kNameTries; ++i) {
    std::string path = private_name(target, i);
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST && errno != EINTR) return {};
    if (descriptor < 0) continue;
    // Without locks on this file system nothing is swept either, so the name is safe all the same.
    const bool is_locked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const bool is_ours = is_locked ? is_still(path, descriptor) : errno != EWOULDBLOCK;
    // Moved: a copy that found no memory would leave the file behind.
    if (is_ours) return {descriptor, std::move(path)};
    ::close(descriptor);  // another writer swept it between the two calls
  }
  errno = EEXIST;
  return {};
}

}  // namespace jalon
