// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"
#include "formats/files/private_file.h"
#include "formats/files/system_error.h"

namespace jalon {

namespace {

constexpr size_t kBufferBytes = size_t{1} << 20;

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(resolved_path(path)), buffer_(kBufferBytes) {
  if (path_.empty()) fail(Status::kIo, "cannot write: the path is empty");
  const FileState old = state_of(path_);
  const bool exists = old.kind != FileKind::kNone;
  if (exists && old.kind != FileKind::kRegular) {
    errno = old.kind == FileKind::kFolder ? EISDIR : EINVAL;
    refuse("write");
  }
  // A read-only file is refused although it could be replaced: its owner said so.
  if (exists && !may_write(path_)) refuse("write");
  PrivateFile file = open_private_file(path_);
  if (file.handle == kNoFile) refuse("create");
  file_ = file.handle;
  temporary_ = std::move(file.path);
  if (exists) take_rights(file_, old);
}

AtomicFile::~AtomicFile() {
  if (file_ != kNoFile) close_file(file_);
  if (!temporary_.empty()) remove_file(temporary_);
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
  if (!write_all(file_, buffer_.data(), filled_)) refuse("write");
  filled_ = 0;
}

void AtomicFile::rewrite(size_t offset, const void* data, size_t bytes) {
  flush();
  if (!write_all_at(file_, offset, data, bytes)) refuse("write");
}

size_t AtomicFile::read_back(uint64_t offset, void* out, size_t bytes) {
  flush();
  size_t done = 0;
  while (done < bytes) {
    const int64_t got = read_at(file_, offset + done, static_cast<char*>(out) + done, bytes - done);
    if (got < 0) refuse("read back");
    if (got == 0) break;
    done += static_cast<size_t>(got);
  }
  return done;
}

void AtomicFile::commit() {
  flush();
  if (!sync_file(file_)) refuse("write");
  // Under the lock still, without which another writer of the same target takes the file for a leftover.
  if (!replace_file(temporary_, path_)) refuse("replace");
  temporary_.clear();
  close_file(std::exchange(file_, kNoFile));
}

}  // namespace jalon
