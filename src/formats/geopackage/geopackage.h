// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "formats/settings.h"
#include "model/model.h"

namespace jalon {

/// GeoPackage 1.3 (OGC 12-128r17): the layers "faces" and "openings" (polygons in space), "elevation" (each facade
/// unrolled: x along it, y the height, z in front of its front), "plan" (where the upright faces are cut, some height
/// above the foot of each facade), and "mesh" where triangles stand for no face. Each feature tells the class, name,
/// facade, evidence, measures and confidence of its part. The place of the model is that of its CRS: by EPSG code, else
/// by its WKT 1, else a local Cartesian one. Equal models give equal files. Error(kUnsupported) in a library without
/// SQLite.
void write_geopackage(const Model& model, const std::string& path, const WriteSettings& settings,
                      Task& task);

}  // namespace jalon
