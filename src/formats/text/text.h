// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/byte_source.h"
#include "formats/files/cloud_pieces.h"
#include "formats/settings.h"

namespace jalon {

/// The start of the file has no byte that plain text has not.
bool is_plain_text(const ByteSource& source);
/// Their points as they stand, finite or not; columns: as the option of this name.
Cloud text_points(const ByteSource& source, const std::string& columns, Task& task);
/// Lines of numbers, whatever separates them: XYZ, CSV.
Cloud read_text(const ByteSource& source, const ReadSettings& settings, Task& task);
/// The same piece by piece, which looks the file through first; null where it is small enough to be read whole.
std::unique_ptr<CloudPieces> text_pieces(const ByteSource& source, const ReadSettings& settings,
                                         Task& task);
/// Whatever its size.
std::unique_ptr<CloudPieces> pieces_of_text(const ByteSource& source, const std::string& columns,
                                            Task& task);
/// Blanks, and "# x y z ..." at the top.
void write_text(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                Task& task);
/// Commas, and a header line.
void write_csv(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task);
/// Writers of pieces, to the same bytes as of the whole.
std::unique_ptr<CloudSink> text_sink(const std::string& path, const WriteSettings& settings,
                                     uint64_t points);
std::unique_ptr<CloudSink> csv_sink(const std::string& path, const WriteSettings& settings,
                                    uint64_t points);

}  // namespace jalon
