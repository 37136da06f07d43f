// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/system_file.h"

#include <algorithm>
#include <cerrno>

#include "base/windows_text.h"

namespace jalon {

namespace {

constexpr size_t kMostAtOnce = size_t{1} << 30;  // a call takes counts of 32 bits
constexpr DWORD kShareAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

HANDLE handle_of(FileHandle file) { return reinterpret_cast<HANDLE>(file); }
FileHandle file_of(HANDLE handle) { return reinterpret_cast<FileHandle>(handle); }

int errno_of(DWORD code) {
  switch (code) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME:
    case ERROR_INVALID_DRIVE:
      return ENOENT;
    case ERROR_DIRECTORY:
      return ENOTDIR;
    case ERROR_ACCESS_DENIED:
    case ERROR_PRIVILEGE_NOT_HELD:
      return EACCES;
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_USER_MAPPED_FILE:
      return EBUSY;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return EEXIST;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
    case ERROR_NOT_ENOUGH_QUOTA:
      return ENOSPC;
    case ERROR_WRITE_PROTECT:
      return EROFS;
    case ERROR_FILE_TOO_LARGE:
      return EFBIG;
    case ERROR_FILENAME_EXCED_RANGE:
      return ENAMETOOLONG;
    case ERROR_TOO_MANY_OPEN_FILES:
      return EMFILE;
    case ERROR_CANT_RESOLVE_FILENAME:
      return ELOOP;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
      return ENOMEM;
    default:
      return EIO;
  }
}

bool failed() {
  errno = errno_of(::GetLastError());
  return false;
}

HANDLE open_handle(const std::string& path, DWORD access, DWORD share, DWORD how, DWORD flags) {
  const HANDLE handle =
      ::CreateFileW(wide_text(path).c_str(), access, share, nullptr, how, flags, nullptr);
  if (handle == INVALID_HANDLE_VALUE) failed();
  return handle;
}

/// Reading and writing at an offset, in one call; the file's own position moves with it.
OVERLAPPED place_of(uint64_t offset) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(offset);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32);
  return place;
}

uint64_t size_of(HANDLE handle) {
  LARGE_INTEGER size{};
  return ::GetFileSizeEx(handle, &size) != 0 ? static_cast<uint64_t>(size.QuadPart) : 0;
}

}  // namespace

FileHandle open_to_read(const std::string& path) {
  // BACKUP_SEMANTICS opens folders too, so that they can be told from what may not be read.
  return file_of(
      open_handle(path, GENERIC_READ, kShareAll, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS));
}

FileState state_of(FileHandle file) {
  BY_HANDLE_FILE_INFORMATION info{};
  if (::GetFileType(handle_of(file)) != FILE_TYPE_DISK) return {FileKind::kOther, 0, 0};
  if (::GetFileInformationByHandle(handle_of(file), &info) == 0) return {};
  if ((info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0) return {FileKind::kFolder, 0, 0};
  return {FileKind::kRegular, size_of(handle_of(file)), 0};
}

FileState state_of(const std::string& path) {
  const HANDLE handle =
      open_handle(path, FILE_READ_ATTRIBUTES, kShareAll, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
  if (handle == INVALID_HANDLE_VALUE) return {};
  const FileState state = state_of(file_of(handle));
  ::CloseHandle(handle);
  return state;
}

std::string resolved_path(const std::string& path) {
  const DWORD attributes = ::GetFileAttributesW(wide_text(path).c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES || (attributes & FILE_ATTRIBUTE_REPARSE_POINT) == 0)
    return path;
  const HANDLE handle =
      open_handle(path, FILE_READ_ATTRIBUTES, kShareAll, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
  if (handle == INVALID_HANDLE_VALUE) return path;
  std::wstring name(::GetFinalPathNameByHandleW(handle, nullptr, 0, FILE_NAME_NORMALIZED), L'\0');
  const DWORD length = ::GetFinalPathNameByHandleW(
      handle, name.data(), static_cast<DWORD>(name.size()), FILE_NAME_NORMALIZED);
  ::CloseHandle(handle);
  if (length == 0 || length >= name.size()) return path;
  name.resize(length);
  return utf8_text(name);
}

bool may_write(const std::string& path) {
  const DWORD attributes = ::GetFileAttributesW(wide_text(path).c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES) return failed();
  if ((attributes & FILE_ATTRIBUTE_READONLY) == 0) return true;
  errno = EACCES;
  return false;
}

int64_t read_at(FileHandle file, uint64_t offset, void* out, size_t bytes) {
  OVERLAPPED place = place_of(offset);
  DWORD n = 0;
  if (::ReadFile(handle_of(file), out, static_cast<DWORD>(std::min(bytes, kMostAtOnce)), &n,
                 &place) != 0)
    return n;
  if (::GetLastError() == ERROR_HANDLE_EOF) return 0;
  failed();
  return -1;
}

bool write_all_at(FileHandle file, uint64_t offset, const void* data, size_t bytes) {
  const auto* from = static_cast<const char*>(data);
  while (bytes > 0) {
    OVERLAPPED place = place_of(offset);
    DWORD n = 0;
    if (::WriteFile(handle_of(file), from, static_cast<DWORD>(std::min(bytes, kMostAtOnce)), &n,
                    &place) == 0)
      return failed();
    if (n == 0) {
      errno = ENOSPC;
      return false;
    }
    from += n;
    offset += n;
    bytes -= n;
  }
  return true;
}

bool write_all(FileHandle file, const void* data, size_t bytes) {
  // Not the file's position, which write_all_at() moves: the writer alone has the file, so its end is where to go on.
  return write_all_at(file, size_of(handle_of(file)), data, bytes);
}

bool sync_file(FileHandle file) {
  return ::FlushFileBuffers(handle_of(file)) != 0 || ::GetLastError() == ERROR_INVALID_FUNCTION ||
         failed();
}

void close_file(FileHandle file) { ::CloseHandle(handle_of(file)); }

// The lock is the sharing of the file: others may rename or delete it, which replace_file() does, but who would open
// it as remove_unlocked() does, sharing it with no writer, is refused until the writer's process ends.
FileHandle create_locked(const std::string& path) {
  return file_of(open_handle(path, GENERIC_READ | GENERIC_WRITE, FILE_SHARE_DELETE, CREATE_NEW,
                             FILE_ATTRIBUTE_NORMAL));
}

void remove_unlocked(const std::string& path) {
  const HANDLE handle = open_handle(path, DELETE, 0, OPEN_EXISTING,
                                    FILE_FLAG_DELETE_ON_CLOSE | FILE_FLAG_OPEN_REPARSE_POINT);
  if (handle != INVALID_HANDLE_VALUE) ::CloseHandle(handle);
}

void remove_file(const std::string& path) { ::DeleteFileW(wide_text(path).c_str()); }

// What a new file may, it inherits from its folder.
void take_rights(FileHandle, const FileState&) {}

bool replace_file(const std::string& from, const std::string& to) {
  return ::MoveFileExW(wide_text(from).c_str(), wide_text(to).c_str(),
                       MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0 ||
         failed();
}

}  // namespace jalon
