// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fuzz {

/// What reads hostile bytes: the readers of files, the bytes of objects, parameters and laws as JSON.
struct Target {
  const char* name;
  void (*read)(const uint8_t* data, size_t size);
  /// Of a checked format: makes changed bytes pass the check, so that they reach what is behind it.
  void (*mend)(std::string& bytes) = nullptr;
};

/// NULL: there is no target of this name.
const Target* find_target(const std::string& name);
/// All, one after another; NULL at the end.
const Target* target(size_t i);

}  // namespace fuzz
