// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/system_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace jalon {

namespace {

constexpr size_t kMostAtOnce = size_t{1} << 30;  // macOS refuses 2 GiB and more in one call

int descriptor_of(FileHandle file) { return static_cast<int>(file); }

FileState state_from(const struct stat& info) {
  const FileKind kind = S_ISREG(info.st_mode)   ? FileKind::kRegular
                        : S_ISDIR(info.st_mode) ? FileKind::kFolder
                                                : FileKind::kOther;
  return {kind, static_cast<uint64_t>(info.st_size), static_cast<uint32_t>(info.st_mode & 07777)};
}

enum class Named { kThis, kOther, kUnknown };

/// What the name stands for: the file that is open, or another or none since somebody swept it away before the lock was
/// held.
Named named_by(const std::string& path, int descriptor) {
  struct stat open {};
  struct stat named {};
  if (::fstat(descriptor, &open) != 0) return Named::kUnknown;
  if (::lstat(path.c_str(), &named) != 0) return errno == ENOENT ? Named::kOther : Named::kUnknown;
  return open.st_dev == named.st_dev && open.st_ino == named.st_ino ? Named::kThis : Named::kOther;
}

/// Calls write(data, bytes) until nothing is left.
template <class Write>
bool write_in_parts(const void* data, size_t bytes, Write write) {
  const auto* from = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t n = write(from, std::min(bytes, kMostAtOnce));
    if (n < 0 && errno == EINTR) continue;
    if (n == 0) errno = ENOSPC;
    if (n <= 0) return false;
    from += n;
    bytes -= static_cast<size_t>(n);
  }
  return true;
}

std::string folder_of(const std::string& path) {
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

FileHandle open_to_read(const std::string& path) {
  int descriptor;
  do descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

FileState state_of(FileHandle file) {
  struct stat info {};
  return ::fstat(descriptor_of(file), &info) == 0 ? state_from(info) : FileState{};
}

FileState state_of(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0 ? state_from(info) : FileState{};
}

std::string resolved_path(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), std::free);
  return real ? std::string(real.get()) : path;
}

bool may_write(const std::string& path) { return ::access(path.c_str(), W_OK) == 0; }

int64_t read_at(FileHandle file, uint64_t offset, void* out, size_t bytes) {
  ssize_t n;
  do
    n = ::pread(descriptor_of(file), out, std::min(bytes, kMostAtOnce), static_cast<off_t>(offset));
  while (n < 0 && errno == EINTR);
  return n;
}

bool write_all(FileHandle file, const void* data, size_t bytes) {
  return write_in_parts(data, bytes, [&](const char* from, size_t n) {
    return ::write(descriptor_of(file), from, n);
  });
}

bool write_all_at(FileHandle file, uint64_t offset, const void* data, size_t bytes) {
  const auto* begin = static_cast<const char*>(data);
  return write_in_parts(data, bytes, [&](const char* from, size_t n) {
    return ::pwrite(descriptor_of(file), from, n,
                    static_cast<off_t>(offset + static_cast<size_t>(from - begin)));
  });
}

bool sync_file(FileHandle file) {
#if defined(F_FULLFSYNC)
  // macOS: fsync alone leaves the data in the cache of the disk.
  if (::fcntl(descriptor_of(file), F_FULLFSYNC) == 0) return true;
#endif
  return ::fsync(descriptor_of(file)) == 0 || errno == EINVAL || errno == EROFS;
}

void close_file(FileHandle file) { ::close(descriptor_of(file)); }

FileHandle create_locked(const std::string& path) {
  int descriptor;
  do descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  while (descriptor < 0 && errno == EINTR);
  if (descriptor < 0) return kNoFile;
  // Without locks on this file system nothing is swept either, so the name is safe all the same; what cannot be asked
  // about is the file that was just made.
  const bool is_locked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  if (is_locked ? named_by(path, descriptor) != Named::kOther : errno != EWOULDBLOCK)
    return descriptor;
  ::close(descriptor);  // another writer swept it between the two calls
  errno = EEXIST;
  return kNoFile;
}

void remove_unlocked(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  if (state_of(FileHandle{descriptor}).kind == FileKind::kRegular &&
      ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && named_by(path, descriptor) == Named::kThis)
    ::unlink(path.c_str());
  ::close(descriptor);
}

void remove_file(const std::string& path) { ::unlink(path.c_str()); }

void take_rights(FileHandle file, const FileState& old) {
  (void)!::fchmod(descriptor_of(file), static_cast<mode_t>(old.rights));
}

bool replace_file(const std::string& from, const std::string& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) return false;
  // The name itself reaches the disk with the folder; where a folder cannot be synced the file is whole all the same.
  const int folder = ::open(folder_of(to).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0) {
    (void)!::fsync(folder);
    ::close(folder);
  }
  return true;
}

}  // namespace jalon
