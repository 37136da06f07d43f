// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/pictures/orthoimage.h"

namespace jalon {

/// An orthoimage as a PNG file, and its world file (ESRI): lines of the pixel's side, two zeros, minus the side, and
/// the place of the middle of the first pixel on the sheet of the elevation.
std::string orthoimage_png(const Orthoimage& image, Task& task);
std::string orthoimage_world(const Orthoimage& image);
/// As GeoTIFF: colours with opacity, or the numbers.
std::string orthoimage_tiff(const Orthoimage& image, Task& task);
/// As an SVG figure with axes in metres, scale bar and the scale of its values.
std::string orthoimage_svg(const Orthoimage& image, const std::string& title, Task& task);

/// Writes a PNG with its world file, or a GeoTIFF, by the extension of the path; Error(kUnsupported) for another.
void write_orthoimage(const Cloud& cloud, const Model& model, const OrthoimageSettings& settings,
                      const std::string& path, Task& task);

}  // namespace jalon
