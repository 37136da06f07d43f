// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace jalon {

constexpr double kFoot = 0.3048;             // international foot, EPSG unit 9002
constexpr double kUsFoot = 1200.0 / 3937.0;  // US survey foot, EPSG unit 9003

/// Metres a unit of the coordinates under a CRS. Clouds are always in metres; files are in the unit
/// of their CRS.
struct LengthUnits {
  double horizontal = 1, vertical = 1;
  bool known = false;    ///< false: the text names no unit, metres are assumed
  bool degrees = false;  ///< geographic coordinates
  bool metres() const { return horizontal == 1 && vertical == 1; }
};

/// Of a CRS text: WKT 1 and 2 by their units, "EPSG:n" and projected systems of a WKT that names no
/// unit by the EPSG dataset. A system without a height unit has that of its plane.
LengthUnits units_of_crs(std::string_view crs);
/// Of a projected or vertical system of the EPSG dataset; 1 for those that are not listed.
double unit_of_epsg(uint32_t code);
/// The n of "EPSG:n"; 0 when the text is something else.
uint32_t epsg_code(std::string_view crs);

}  // namespace jalon
