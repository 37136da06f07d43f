// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bytes/byte_reader.h"
#include "bytes/byte_writer.h"
#include "cloud/cloud.h"

namespace jalon {

/// Points, fields, stations, CRS and what a file format wants back; not the index, which is built anew when it is
/// needed. The cloud must live until the writer has sealed.
void write_cloud(ByteWriter& writer, const Cloud& cloud);
/// A cloud that keeps what clouds promise: finite points, fields of their number, stations in order.
Cloud read_cloud(ByteReader& reader, Task& task);

}  // namespace jalon
