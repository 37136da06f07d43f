// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bytes/byte_reader.h"
#include "bytes/byte_writer.h"
#include "registration/registration.h"

namespace jalon {

/// It must live until the writer has sealed.
void write_registration(ByteWriter& writer, const Registration& registration);
/// One whose pose is finite, with a summary of one row and the six directions.
Registration read_registration(ByteReader& reader, Task& task);

}  // namespace jalon
