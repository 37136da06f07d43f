// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "base/params.h"
#include "base/task.h"
#include "segment/segmentation.h"

namespace jalon {

/// Parameter table of operation "picture".
std::span<const ParamRow> picture_rows();

/// The labelled points as an SVG figure: axes in metres, scale bar, numbers and legend of the segments; the points are
/// a PNG inside it.
std::string picture_svg(const Segmentation& segmentation, const ParamSet& options, Task& task);
/// The points alone as a PNG file.
std::string picture_png(const Segmentation& segmentation, const ParamSet& options, Task& task);

}  // namespace jalon
