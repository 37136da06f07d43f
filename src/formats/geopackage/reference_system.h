// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "formats/geopackage/sqlite_database.h"

namespace jalon::gpkg {

/// Of layers whose coordinates are those of no map: metres of a plane or a space of their own. (0 would be degrees.)
constexpr int32_t kLocalCartesian = -1;

/// Fills gpkg_spatial_ref_sys: the three rows that each file must have, and that of the model's CRS. Returns the srs_id
/// of the latter: its EPSG code where it has one in metres; where it is WKT 1 of a projected system in metres without
/// code the first number that is free for users; else kLocalCartesian.
int32_t add_reference_systems(Database& database, const std::string& crs);

}  // namespace jalon::gpkg
