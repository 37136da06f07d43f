// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace jalon {

// What files need of the operating system, and the only place that asks for it: system_file_posix.cpp (Linux, macOS)
// or system_file_windows.cpp is compiled. Paths are UTF-8. What fails leaves the reason in errno.

using FileHandle = std::intptr_t;  ///< a descriptor; on Windows a HANDLE
constexpr FileHandle kNoFile = -1;

enum class FileKind { kNone, kRegular, kFolder, kOther };

struct FileState {
  FileKind kind = FileKind::kNone;
  uint64_t size = 0;    ///< bytes
  uint32_t rights = 0;  ///< of owner, group and others; unused on Windows
};

/// Never waits, neither for the other end of a pipe nor for a lock.
FileHandle open_to_read(const std::string& path);
FileState state_of(FileHandle file);
/// Of what symbolic links lead to; kNone: nothing can be found there.
FileState state_of(const std::string& path);
/// The path behind symbolic links; the same path where nothing is there.
std::string resolved_path(const std::string& path);
/// A file whose owner made it read-only may not.
bool may_write(const std::string& path);

/// At most `bytes`; 0 at the end of the file, -1 on failure.
int64_t read_at(FileHandle file, uint64_t offset, void* out, size_t bytes);
/// All of them, behind what was written last.
bool write_all(FileHandle file, const void* data, size_t bytes);
/// All of them, at an offset, which write_all() does not follow.
bool write_all_at(FileHandle file, uint64_t offset, const void* data, size_t bytes);
/// Until the disk has it; file systems that cannot are no failure.
bool sync_file(FileHandle file);
void close_file(FileHandle file);

/// A new file, locked for as long as it is open; kNoFile with EEXIST when another writer has the name.
FileHandle create_locked(const std::string& path);
/// Removes a file that nobody has locked: the system lets go of a lock when its process ends, however it ends.
void remove_unlocked(const std::string& path);
void remove_file(const std::string& path);
/// The rights of a file that is to be replaced; a new file that cannot have them is still a good file.
void take_rights(FileHandle file, const FileState& old);
/// Gives the open file another name, in place of what has it, at once: others see the old file or the new one.
bool replace_file(const std::string& from, const std::string& to);

}  // namespace jalon
