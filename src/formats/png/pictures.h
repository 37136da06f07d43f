// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "formats/drawings/pixels.h"

namespace jalon {

/// A picture as a PNG file by libpng; a library without it is Error(kUnsupported), see png::has_libpng().
std::string png_of(const IndexedImage& image);
std::string png_of(const RgbaImage& image, Task& task);

}  // namespace jalon
