// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/task.h"

namespace jalon {

/// What zlib looks for in the bytes.
enum class Redundancy {
  kAny,   ///< whatever repeats: pictures
  kRuns,  ///< runs of a byte, and which bytes are frequent: differences of neighbours, of which little else repeats
};

/// zlib stream (RFC 1950) of the bytes, deflated in blocks that know nothing of each other. Parallel; the same bytes
/// for any number of threads.
std::string zlib_stream(std::string_view bytes, Redundancy redundancy, Task& task);

}  // namespace jalon
