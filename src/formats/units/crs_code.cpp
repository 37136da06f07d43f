// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/units/crs_code.h"

#include <algorithm>
#include <charconv>

#include "formats/files/utf8.h"
#include "formats/units/length_units.h"

namespace jalon {

namespace {

constexpr uint32_t kMaxCode = 999999;

// The digits behind the last separator: "urn:ogc:def:crs:EPSG::2154", ".../def/crs/EPSG/0/2154".
uint32_t last_number(std::string_view text) {
  const size_t at = text.find_last_of(":/");
  const std::string_view digits = at == std::string_view::npos ? text : text.substr(at + 1);
  uint32_t code = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code);
  return error == std::errc() && end == digits.data() + digits.size() && code <= kMaxCode ? code
                                                                                          : 0;
}

bool is_metric(const LengthUnits& units) { return units.metres() && !units.degrees; }

}  // namespace

uint32_t wkt_epsg_code(std::string_view text) {
  size_t depth = 0, start = std::string_view::npos;
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '[' || c == '(') {
      if (depth++ != 1) continue;
      const std::string_view before = text.substr(0, i);
      if (before.ends_with("AUTHORITY") || before.ends_with("ID")) start = i + 1;
    } else if ((c == ']' || c == ')') && depth > 0) {
      --depth;
    }
  }
  if (start == std::string_view::npos || !text.substr(start).starts_with("\"EPSG\",")) return 0;
  std::string_view digits = text.substr(start + 7);
  while (!digits.empty() && (digits.front() == '"' || digits.front() == ' '))
    digits.remove_prefix(1);
  uint32_t code = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code);
  return error == std::errc() && code <= kMaxCode ? code : 0;
}

bool is_local_crs(std::string_view crs) {
  const std::string_view word =
      crs.substr(std::min(crs.find_first_not_of(" \t\r\n"), crs.size()), 16);
  const std::string small = lower(word.substr(0, word.find_first_of("[( ")));
  return small == "local_cs" || small == "engcrs" || small == "engineeringcrs";
}

uint32_t metric_epsg_code(std::string_view crs) {
  const std::string small = lower(crs.substr(0, 64));
  const bool named = small.starts_with("epsg:") || small.starts_with("urn:ogc:def:crs:epsg:") ||
                     small.find("/def/crs/epsg/") != std::string::npos;
  const uint32_t code = named ? last_number(crs) : wkt_epsg_code(crs);
  // A WKT may name no unit, or another than its code has: a reader of the code sees the code's.
  if (code == 0 || !is_metric(units_of_crs("EPSG:" + std::to_string(code)))) return 0;
  return named || is_metric(units_of_crs(crs)) ? code : 0;
}

}  // namespace jalon
