// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace jalon {

/// EPSG code of a CRS text, for formats that name the system by its code: "EPSG:2154", OGC URNs and URLs, and WKT 1 and
/// 2 by the identifier of the whole. 0 when it has none, or when its unit is not the metre: the library's coordinates
/// are metres, and such a name would be wrong.
uint32_t metric_epsg_code(std::string_view crs);
/// Of a WKT as a whole, whatever its unit: AUTHORITY["EPSG","2154"] (WKT 1) or ID["EPSG",2154] (WKT 2) inside the
/// outermost bracket only; 0 without one.
uint32_t wkt_epsg_code(std::string_view text);
/// Is it a system of a place of its own, which no map has: LOCAL_CS (WKT 1), ENGCRS or ENGINEERINGCRS (WKT 2)? Its axes
/// need not point to the north.
bool is_local_crs(std::string_view crs);

}  // namespace jalon
