// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/json_writer.h"
#include "model/model.h"

namespace jalon {

/// Members "opening_types", "openings" and "parts" of an open object: what the page tells of them. Unknown numbers are
/// null; "part", "parent" and "copied_from" are places in "parts", or null.
void write_model_parts(JsonWriter& json, const Model& model);

}  // namespace jalon
