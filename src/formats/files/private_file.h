// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "formats/files/system_file.h"

namespace jalon {

/// A new file beside a target, locked for as long as it is open.
struct PrivateFile {
  FileHandle handle = kNoFile;  ///< kNoFile: none could be made, errno says why
  std::string path;
};

/// Makes the first free one of PATH.jalon0.part, PATH.jalon1.part ... Those that nobody holds a lock
/// of are what killed writers left: they are taken away first. Where the file system knows no locks
/// they stay.
PrivateFile open_private_file(const std::string& target);

}  // namespace jalon
