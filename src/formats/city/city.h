// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "formats/files/byte_source.h"
#include "formats/settings.h"
#include "model/model.h"
#include "model/part_attributes.h"

namespace jalon {

Model read_city(const ByteSource& source, const ReadSettings& settings, Task& task);
void write_city(const Model& model, const std::string& path, const WriteSettings& settings,
                Task& task);
/// With attributes beside those that the model has: of buildings, of semantic surfaces, of groups.
void write_city_attributes(const Model& model, const PartAttributes& attributes,
                           const std::string& path, const WriteSettings& settings, Task& task);

}  // namespace jalon
