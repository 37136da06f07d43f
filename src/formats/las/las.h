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

bool is_las(const ByteSource& source);
/// A LAS file whose points are compressed.
bool is_laz(const ByteSource& source);
/// A LAZ file whose chunks are the nodes of an octree.
bool is_copc(const ByteSource& source);
/// Compressed or not; of COPC the part that the options "box" and "spacing_m" ask for, whole nodes.
Cloud read_las(const ByteSource& source, const ReadSettings& settings, Task& task);
/// The same piece by piece; of LAZ whole chunks. Null where the file tells stations: their points are put in order.
std::unique_ptr<CloudPieces> las_pieces(const ByteSource& source, const ReadSettings& settings,
                                        Task& task);
void write_las(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task);
/// The same file with compressed points.
void write_laz(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task);
/// Writers of pieces, to the same bytes as of the whole; points: of all pieces at most.
std::unique_ptr<CloudSink> las_sink(const std::string& path, const WriteSettings& settings,
                                    uint64_t points);
std::unique_ptr<CloudSink> laz_sink(const std::string& path, const WriteSettings& settings,
                                    uint64_t points);
/// Its points as an octree.
void write_copc(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                Task& task);

}  // namespace jalon
