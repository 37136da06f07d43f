// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bytes/byte_reader.h"
#include "bytes/byte_writer.h"
#include "model/model.h"

namespace jalon {

/// All tables of the model, its parts and its CRS; it must live until the writer has sealed.
void write_model(ByteWriter& writer, const Model& model);
/// A model that keeps what models promise: indices that lead somewhere (validate()), parts in a tree.
Model read_model(ByteReader& reader);

}  // namespace jalon
