// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "cloud/sections/sections.h"
#include "formats/files/byte_source.h"
#include "formats/settings.h"
#include "model/model.h"

namespace jalon {

/// A drawing as a model: a part a layer, with the class that its name tells where it is one of ours; closed polylines
/// (arcs too) and circles as faces; 3DFACE, SOLID, MESH, polygon and polyface meshes as triangles, or as faces
/// ("polygons" = "faces"); blocks where they are inserted. Rings of our own drawings become faces with holes and parts
/// again. In metres by $INSUNITS or the option "unit". Other entities are counted in the log.
Model read_dxf(const ByteSource& source, const ReadSettings& settings, Task& task);
void write_dxf(const Model& model, const std::string& path, const WriteSettings& settings,
               Task& task);
/// Sections where they are in space, each on a layer that has its name, its lines as polylines, closed or open.
void write_dxf(const Sections& sections, const std::string& path, const WriteSettings& settings,
               Task& task);

}  // namespace jalon
