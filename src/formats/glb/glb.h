// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "formats/settings.h"
#include "model/model.h"

namespace jalon {

/// glTF 2.0 in one binary file, for viewers: a node a part with its class, evidence and measures as "extras", faces as
/// triangles in the colour of the class, openings that are holes as their outlines. Coordinates are float32 from a
/// whole metre that the root node's matrix adds, which also turns Z up into glTF's Y up.
void write_glb(const Model& model, const std::string& path, const WriteSettings& settings,
               Task& task);

}  // namespace jalon
