// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "formats/settings.h"
#include "model/model.h"

namespace jalon {

/// IFC4 (ISO 16739-1:2018, as a STEP file): project, site, buildings with one storey each, walls, openings that void
/// them, windows and doors that fill the openings, other parts as proxies with their class; what is known of each
/// (sigma, evidence, confidence, measures) as the property set "Jalon_Precision", its area or volume as a quantity.
/// Coordinates count from a whole metre: of the map conversion where the CRS has an EPSG code, else of the site.
/// Walls are the measured surfaces with their holes; with a thickness they are solids behind those, which the openings
/// cut. Equal models give equal files: nothing tells the time, and identifiers are hashed from the names.
void write_ifc(const Model& model, const std::string& path, const WriteSettings& settings,
               Task& task);

}  // namespace jalon
