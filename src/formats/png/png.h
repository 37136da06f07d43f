// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/byte_source.h"
#include "formats/settings.h"

namespace jalon {

bool is_png(const ByteSource& source);
/// A depth image: a point for each pixel that has a return, with fields row (from the top) and column. What pixels and
/// grey values are in metres is told by the file itself (see png/grid.h), by a world file and the options, or by these.
/// Grey pictures of 1 to 16 bits; transparent pixels, or where there are none those of value 0, have no return.
/// Needs libpng.
Cloud read_png(const ByteSource& source, const ReadSettings& settings, Task& task);
/// The depth image of a cloud seen from the direction of the options, the nearest point of each pixel; grey values of
/// 16 or 8 bits from the farthest point to the nearest, 0 (transparent) where there is none. Fields are not kept. Needs
/// libpng.
void write_png(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task);

}  // namespace jalon
