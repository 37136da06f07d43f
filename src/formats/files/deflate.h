// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace jalon {

/// zlib stream (RFC 1950, 1951) of one block with the fixed code. Repetitions are sought at two distances only: the
/// byte before, and one row before (row_bytes <= 32768; 0 = none), which is what even areas of pictures need.
std::string zlib_of(std::string_view bytes, size_t row_bytes);

}  // namespace jalon
