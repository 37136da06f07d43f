// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/atomic_file.h"

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "formats/files/private_file.h"
#include "formats/files/system_error.h"

namespace jalon {

namespace {

constexpr size_t kBufferBytes = size_t{1} << 20;

// The file behind symbolic links: the link stays, what it names is replaced.
std::string resolved(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), std::free);
  return real ? std::string(real.get()) : path;
}

std::string folder_of(const std::string& path) {
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(resolved(path)), buffer_(kBufferBytes) {
  if (path_.empty()) fail(Status::kIo, "cannot write: the path is empty");
  struct stat old {};
  const bool exists = ::stat(path_.c_str(), &old) == 0;
  if (exists && !S_ISREG(old.st_mode)) {
    errno = S_ISDIR(old.st_mode) ? EISDIR : EINVAL;
    refuse("write");
  }
  // A read-only file is refused although rename could replace it: its owner said so.
  if (exists && ::access(path_.c_str(), W_OK) != 0) refuse("write");
  PrivateFile file = open_private_file(path_);
  if (file.descriptor < 0) refuse("create");
  descriptor_ = file.descriptor;
  temporary_ = std::move(file.path);
  if (exists)
    (void)!::fchmod(
        descriptor_,
        old.st_mode & 07777);  // a new file that cannot have the old rights is still a good file
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::refuse(const char* action) const {
  const std::string cause = system_error_text(errno);
  fail(Status::kIo, "%s: cannot %s: %s", path_.c_str(), action, cause.c_str());
}

void AtomicFile::write(const void* data, size_t bytes) {
  const auto* from = static_cast<const char*>(data);
  while (bytes > 0) {
    const size_t part = std::min(bytes, buffer_.size() - filled_);
    std::memcpy(buffer_.data() + filled_, from, part);
    filled_ += part;
    from += part;
    bytes -= part;
    if (filled_ == buffer_.size()) flush();
  }
}

void AtomicFile::flush() {
  size_t done = 0;
  while (done < filled_) {
    const ssize_t n = ::write(descriptor_, buffer_.data() + done, filled_ - done);
    if (n < 0 && errno == EINTR) continue;
    if (n == 0) errno = ENOSPC;
    if (n <= 0) refuse("write");
    done += static_cast<size_t>(n);
  }
  filled_ = 0;
}

void AtomicFile::rewrite(size_t offset, const void* data, size_t bytes) {
  flush();
  const auto* from = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t n = ::pwrite(descriptor_, from, bytes, static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n == 0) errno = ENOSPC;
    if (n <= 0) refuse("write");
    from += n;
    offset += static_cast<size_t>(n);
    bytes -= static_cast<size_t>(n);
  }
}

void AtomicFile::commit() {
  flush();
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) refuse("write");
  if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) refuse("write");
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) refuse("replace");
  temporary_.clear();
  // The name itself reaches the disk with the folder; where a folder cannot be synced the file is
  // whole all the same.
  const int folder = ::open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0) {
    (void)!::fsync(folder);
    ::close(folder);
  }
}

}  // namespace jalon
