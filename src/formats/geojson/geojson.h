// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "formats/settings.h"
#include "model/model.h"

namespace jalon {

void write_geojson(const Model& model, const std::string& path, const WriteSettings& settings,
                   Task& task);

}  // namespace jalon
