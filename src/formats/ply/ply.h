// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/byte_source.h"
#include "formats/settings.h"
#include "model/model.h"

namespace jalon {

bool is_ply(const ByteSource& source);
Cloud read_ply(const ByteSource& source, const ReadSettings& settings, Task& task);
void write_ply(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task);
Model read_ply_model(const ByteSource& source, const ReadSettings& settings, Task& task);
void write_ply_model(const Model& model, const std::string& path, const WriteSettings& settings,
                     Task& task);

}  // namespace jalon
