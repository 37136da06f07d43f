// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/private_file.h"

#include <cerrno>
#include <utility>

namespace jalon {

namespace {

constexpr int kNameTries = 1000;  // writers of one target at once
constexpr int kSwept = 16;        // names that are always looked at for leftovers

std::string private_name(const std::string& target, int number) {
  return target + ".jalon" + std::to_string(number) + ".part";
}

}  // namespace

PrivateFile open_private_file(const std::string& target) {
  for (int i = 0; i < kSwept; ++i) remove_unlocked(private_name(target, i));
  for (int i = 0; i < kNameTries; ++i) {
    std::string path = private_name(target, i);
    const FileHandle handle = create_locked(path);
    // Moved: a copy that found no memory would leave the file behind.
    if (handle != kNoFile) return {handle, std::move(path)};
    if (errno != EEXIST) return {};
  }
  errno = EEXIST;
  return {};
}

}  // namespace jalon
