// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/byte_source.h"
#include "formats/settings.h"

namespace jalon {

/// Leica's text of points: blocks of a count and lines "x y z", "x y z intensity", "x y z r g b" or
/// "x y z intensity r g b". Several blocks are stations without pose; a count that lies gives a
/// warning, for the lines tell.
Cloud read_pts(const ByteSource& source, const ReadSettings& settings, Task& task);

}  // namespace jalon
