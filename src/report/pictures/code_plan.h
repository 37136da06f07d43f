// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "formats/drawings/pixels.h"
#include "segment/codes/notes_reader.h"
#include "segment/segmentation.h"

namespace jalon {

/// Colour of the points of a class: those that the codes' source shows them in, rest blue (pale, as paper is), walls
/// green, doors yellow, windows orange, gutters red; violet and browns for classes of a table of one's own.
Rgb class_colour(int64_t class_code);

/// Plan of a segmentation by codes as an SVG figure, north up, axes in metres: the points in the colours of their
/// classes, where several lie above each other the one of the highest class; outlines of buildings, openings, gutters,
/// linkages; the surveyed points with their codes, as far as there is room. Scale bar and legend.
std::string code_plan_svg(const Segmentation& segmentation, const CodedNotes& notes,
                          const std::string& title, Task& task);

}  // namespace jalon
