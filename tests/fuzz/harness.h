// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "jalon/jalon.h"

namespace fuzz {

/// A failure is one line that says something, and never that of a bug; else the program ends here.
bool succeeds(jalon_status status);
/// Makes what the inputs need to be tried at all: ends the program where that fails.
void must(jalon_status status);

/// Where an input is written to, by its extension; in memory where the system has such a folder.
std::string place_of(const std::string& extension);
std::string file_with(const std::string& extension, const void* data, size_t size);

/// With one thread: the fuzzer's processes are as many as there is room for.
jalon_task* one_thread();

/// Takes the text before the first of these bytes, and leaves what is behind it.
std::string take_text(const uint8_t*& data, size_t& size, char end);

}  // namespace fuzz
