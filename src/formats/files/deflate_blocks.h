// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/task.h"

namespace jalon {

/// zlib stream (RFC 1950, 1951) of blocks that have their own Huffman codes each, and of
/// repetitions those of the byte before: for numbers of which one byte after another is told,
/// whose frequencies say more than their order. Parallel; the same bytes for any number of threads.
std::string zlib_blocks(std::string_view bytes, Task& task);

}  // namespace jalon
