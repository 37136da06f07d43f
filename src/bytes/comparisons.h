// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bytes/byte_reader.h"
#include "bytes/byte_writer.h"
#include "compare/comparison.h"

namespace jalon {

/// With the compared points; it must live until the writer has sealed.
void write_comparison(ByteWriter& writer, const Comparison& comparison);
/// One whose columns are those of jalon/comparer.h, one row a point.
Comparison read_comparison(ByteReader& reader, Task& task);

}  // namespace jalon
