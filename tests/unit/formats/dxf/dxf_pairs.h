// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

// Drawings written group by group.
namespace jalon::test {

/// "0 LINE 8 WALLS": blanks between codes and values, which have none themselves.
inline std::string pairs(const std::string& words) {
  std::string out;
  for (const char c : words) out += c == ' ' || c == '\n' ? '\n' : c;
  return out + "\n";
}

inline std::string section(const std::string& name, const std::string& groups) {
  return pairs("0 SECTION 2 " + name) + groups + pairs("0 ENDSEC");
}

/// A square of this side with a corner at (x, y) as LWPOLYLINE.
inline std::string square(double x, double y, double side, const std::string& more = "") {
  const auto n = [](double v) { return std::to_string(v); };
  std::string out = "0 LWPOLYLINE 8 " + std::string(more.empty() ? "WALL" : more) + " 90 4 70 1";
  const double corners[4][2] = {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
  for (const auto& c : corners) out += " 10 " + n(c[0]) + " 20 " + n(c[1]);
  return pairs(out);
}

}  // namespace jalon::test
