// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/params.h"
#include "bytes/byte_reader.h"
#include "bytes/byte_writer.h"

namespace jalon {

/// All values by name, the defaults too: they mean the same where a later release has others.
void write_values(ByteWriter& writer, const ParamSet& params);
/// Sets the values by name, checked as when they are set; rows that are not named stay as they are.
void read_values(ByteReader& reader, ParamSet& params);

}  // namespace jalon
