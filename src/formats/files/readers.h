// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/byte_source.h"
#include "model/model.h"

// One reader or writer a format; formats/formats.h chooses among them.
namespace jalon {

Cloud read_las(const ByteSource& source, const ParamSet& options, Task& task);
Cloud read_ply(const ByteSource& source, const ParamSet& options, Task& task);
Cloud read_text(const ByteSource& source, const ParamSet& options, Task& task);
Model read_ply_model(const ByteSource& source, const ParamSet& options, Task& task);
Model read_obj(const ByteSource& source, const ParamSet& options, Task& task);
Model read_stl(const ByteSource& source, Task& task);
Model read_city(const ByteSource& source, const ParamSet& options, Task& task);
/// The number of triangles that a binary STL file states fits its size.
bool is_binary_stl(const ByteSource& source);

void write_las(const Cloud& cloud, const std::string& path, const ParamSet& options, Task& task);
void write_ply(const Cloud& cloud, const std::string& path, const ParamSet& options, Task& task);
/// comma: CSV with a header line; otherwise blanks and "# x y z ...".
void write_text(const Cloud& cloud, const std::string& path, bool comma, const ParamSet& options,
                Task& task);
void write_ply_model(const Model& model, const std::string& path, const ParamSet& options,
                     Task& task);
void write_obj(const Model& model, const std::string& path, const ParamSet& options, Task& task);
void write_stl(const Model& model, const std::string& path, const ParamSet& options, Task& task);
void write_dxf(const Model& model, const std::string& path, const ParamSet& options, Task& task);
void write_geojson(const Model& model, const std::string& path, const ParamSet& options, Task& task);
void write_city(const Model& model, const std::string& path, const ParamSet& options, Task& task);

/// What all cloud readers do last: refuses the first point that is not finite, naming it, or drops
/// all of them ("drop_invalid").
Cloud finish_cloud(Cloud cloud, const ByteSource& source, const ParamSet& options, Task& task);

}  // namespace jalon
