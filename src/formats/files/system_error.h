// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cerrno>
#include <string>

namespace jalon {

/// What an errno means, in English whatever the locale, and safe in any thread.
inline std::string system_error_text(int code) {
  switch (code) {
    case ENOENT:
      return "no such file or folder";
    case ENOTDIR:
      return "a part of the path is no folder";
    case EISDIR:
      return "it is a folder";
    case EACCES:
    case EPERM:
      return "permission denied";
    case EROFS:
      return "the file system is read-only";
    case ENOSPC:
      return "no space left on the disk";
#if defined(EDQUOT)  // not on Windows
    case EDQUOT:
      return "the disk quota is used up";
#endif
    case EFBIG:
      return "the file would be too large";
    case ENAMETOOLONG:
      return "the name is too long";
    case EMFILE:
    case ENFILE:
      return "too many open files";
    case EBUSY:
      return "another program uses it";
    case EIO:
      return "the device failed";
    case ELOOP:
      return "too many symbolic links";
    case EINVAL:
      return "it is no regular file";
    default:
      return "system error " + std::to_string(code);
  }
}

}  // namespace jalon
