// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bytes/byte_reader.h"
#include "bytes/byte_writer.h"
#include "segment/segmentation.h"

namespace jalon {

/// With its cloud; it must live until the writer has sealed.
void write_segmentation(ByteWriter& writer, const Segmentation& segmentation);
/// One whose labels lead to its segments, and whose planes have unit normals.
Segmentation read_segmentation(ByteReader& reader, Task& task);

}  // namespace jalon
