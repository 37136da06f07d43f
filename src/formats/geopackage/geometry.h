// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/vec.h"

// Geometries as a GeoPackage stores them (OGC 12-128r17, 2.1.3): a header with the box in x and y, then ISO WKB with
// z, all little-endian. Rings come without their first corner again.
namespace jalon::gpkg {

using Line = std::vector<Vec3>;
using Polygon = std::vector<Line>;  ///< the outline, then holes

std::string line_bytes(const Line& line, int32_t srs_id);
std::string polygon_bytes(const Polygon& polygon, int32_t srs_id);
std::string polygons_bytes(const std::vector<Polygon>& polygons, int32_t srs_id);

}  // namespace jalon::gpkg
