// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace jalon {

/// WKT 1 (OGC 01-009) of a projected system of the EPSG dataset in metres, for formats that take no code: UTM on WGS 84
/// (32601 ... 32660, 32701 ... 32760) and on ETRS89 (25828 ... 25837), Lambert-93 (2154) and the nine conic zones CC42
/// ... CC50 of France (3942 ... 3950). "" for all others: the dataset is no part of the library.
std::string wkt_of_epsg(uint32_t code);

}  // namespace jalon
