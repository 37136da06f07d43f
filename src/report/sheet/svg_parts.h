// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/drawings/svg_writer.h"
#include "geometry/vec.h"

namespace jalon {

// Small parts that the drawings share. Lengths in the drawing's unit (mm on sheets).

constexpr const char* kInk = "#1a1a1a";
constexpr const char* kGrey = "#777777";
constexpr const char* kFaint = "#dddddd";

enum class Anchor { kStart, kMiddle, kEnd };

void svg_line(SvgWriter& svg, const Vec2& a, const Vec2& b, const char* colour, double width);
/// Text on a base line; turned 90 degrees to the left when upright. size is the height of the font.
void svg_text(SvgWriter& svg, const Vec2& at, double size, Anchor anchor, std::string_view text,
              bool bold = false, bool upright = false, const char* colour = kInk);
/// d of a <path>: closed rings.
std::string svg_rings(std::span<const std::vector<Vec2>> rings);
/// d of a <path>: an open line.
std::string svg_polyline(std::span<const Vec2> points);

/// 123456 as "123 456".
std::string grouped(uint64_t n);
/// Width that a text takes at most, for layouts (sans-serif digits and capitals).
double text_width(std::string_view text, double size);
/// The text, cut with "..." after whole characters to fit.
std::string fitted_text(std::string_view text, double size, double width);

}  // namespace jalon
