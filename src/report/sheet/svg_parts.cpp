// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/sheet/svg_parts.h"

#include "base/utf8_character.h"

namespace jalon {

namespace {

constexpr double kCharacterWidth = 0.6;  // of the font height: an upper mean for sans-serif faces

const char* name_of(Anchor anchor) {
  return anchor == Anchor::kStart ? "start" : anchor == Anchor::kMiddle ? "middle" : "end";
}

size_t characters(std::string_view text) {
  size_t n = 0;
  for (const char c : text)
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) ++n;
  return n;
}

void append_point(std::string& d, char command, const Vec2& p) {
  d += command;
  d += svg_number(p.u);
  d += ' ';
  d += svg_number(p.v);
}

}  // namespace

void svg_line(SvgWriter& svg, const Vec2& a, const Vec2& b, const char* colour, double width) {
  svg.leaf("line", {{"x1", a.u},
                    {"y1", a.v},
                    {"x2", b.u},
                    {"y2", b.v},
                    {"stroke", colour},
                    {"stroke-width", width}});
}

void svg_text(SvgWriter& svg, const Vec2& at, double size, Anchor anchor, std::string_view text,
              bool bold, bool upright, const char* colour) {
  const std::string turn =
      upright ? "rotate(-90 " + svg_number(at.u) + " " + svg_number(at.v) + ")" : "rotate(0)";
  svg.element("text",
              {{"x", at.u},
               {"y", at.v},
               {"font-size", size},
               {"text-anchor", name_of(anchor)},
               {"font-weight", bold ? "bold" : "normal"},
               {"fill", colour},
               {"transform", turn}},
              text);
}

std::string svg_rings(std::span<const std::vector<Vec2>> rings) {
  std::string d;
  for (const auto& ring : rings) {
    for (size_t i = 0; i < ring.size(); ++i) append_point(d, i == 0 ? 'M' : 'L', ring[i]);
    d += 'Z';
  }
  return d;
}

std::string svg_polyline(std::span<const Vec2> points) {
  std::string d;
  for (size_t i = 0; i < points.size(); ++i) append_point(d, i == 0 ? 'M' : 'L', points[i]);
  return d;
}

std::string grouped(uint64_t n) {
  const std::string digits = std::to_string(n);
  std::string out;
  for (size_t i = 0; i < digits.size(); ++i) {
    if (i != 0 && (digits.size() - i) % 3 == 0) out += ' ';
    out += digits[i];
  }
  return out;
}

double text_width(std::string_view text, double size) {
  return kCharacterWidth * size * static_cast<double>(characters(text));
}

std::string fitted_text(std::string_view text, double size, double width) {
  if (text_width(text, size) <= width) return std::string(text);
  std::string out;
  for (size_t i = 0; i < text.size();) {
    const size_t n = std::max<size_t>(1, utf8_character_bytes(text.substr(i)));
    if (text_width(out, size) + 4 * kCharacterWidth * size > width) break;
    out += text.substr(i, n);
    i += n;
  }
  return out + "...";
}

}  // namespace jalon
