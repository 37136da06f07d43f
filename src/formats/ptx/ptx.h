// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/byte_source.h"
#include "formats/settings.h"

namespace jalon {

/// Leica's text of scans in a grid: a station for each, whose pose its points have been moved by;
/// fields row and column (from 0, as the file counts), intensity, red, green, blue. A beam without
/// return ("0 0 0") leaves its cell of the grid empty.
Cloud read_ptx(const ByteSource& source, const ReadSettings& settings, Task& task);

}  // namespace jalon
