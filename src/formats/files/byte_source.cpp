// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/byte_source.h"

#include <cerrno>
#include <cstdarg>
#include <cstdio>

#include "base/error.h"
#include "formats/files/system_error.h"

namespace jalon {

ByteSource::ByteSource(std::string path) : path_(std::move(path)) {
  // Without waiting, so that a named pipe is refused below.
  file_ = open_to_read(path_);
  if (file_ == kNoFile) {
    const int code = errno;
    const std::string cause = system_error_text(code);
    fail(code == ENOENT || code == ENOTDIR ? Status::kNotFound : Status::kIo, "%s: cannot open: %s",
         path_.c_str(), cause.c_str());
  }
  const FileState state = state_of(file_);
  if (state.kind != FileKind::kRegular) {
    close_file(file_);
    fail(Status::kIo, "%s: cannot read: %s", path_.c_str(),
         state.kind == FileKind::kFolder ? "it is a folder" : "it is no regular file");
  }
  size_ = state.size;
}

ByteSource::~ByteSource() { close_file(file_); }

size_t ByteSource::read_some(uint64_t offset, void* out, size_t bytes) const {
  size_t done = 0;
  while (done < bytes) {
    const int64_t n = read_at(file_, offset + done, static_cast<char*>(out) + done, bytes - done);
    if (n < 0) {
      const std::string cause = system_error_text(errno);
      fail(Status::kIo, "%s: offset %llu: cannot read: %s", path_.c_str(),
           static_cast<unsigned long long>(offset + done), cause.c_str());
    }
    if (n == 0) break;
    done += static_cast<size_t>(n);
  }
  return done;
}

void ByteSource::read(uint64_t offset, void* out, size_t bytes) const {
  if (!has(offset, bytes) || read_some(offset, out, bytes) != bytes)
    refuse(offset, "the file ends before the %llu bytes that belong here",
           static_cast<unsigned long long>(bytes));
}

void ByteSource::refuse(uint64_t offset, const char* format, ...) const {
  char reason[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(reason, sizeof reason, format, arguments);
  va_end(arguments);
  // Built as a string: a long path must not push the reason out of the line.
  std::string line = path_.size() <= 400 ? path_ : "..." + path_.substr(path_.size() - 397);
  line += ": offset " + std::to_string(offset) + ": " + reason;
  throw Error(Status::kFormat, std::move(line));
}

}  // namespace jalon
