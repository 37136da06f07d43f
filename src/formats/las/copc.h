// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/task.h"
#include "formats/files/byte_source.h"
#include "formats/las/laz.h"
#include "formats/las/layout.h"
#include "geometry/vec.h"

// Cloud Optimized Point Cloud 1.0 (copc.io, 2021): a LAZ 1.4 file of point formats 6-8 whose chunks are
// the nodes of an octree, each with points that no other has. A record at the beginning tells the cube
// and the place of the hierarchy: pages of entries, each of which places the chunk of a node, or the
// page that continues the tree below it.
namespace jalon::las {

constexpr const char* kCopcUser = "copc";
constexpr unsigned kCopcInfoRecord = 1, kCopcHierarchyRecord = 1000;
constexpr size_t kCopcInfoBytes = 160, kCopcEntryBytes = 32;
constexpr int kMostCopcLevel = 31;  ///< what 32 bits of a key hold

/// The record "copc" 1; lengths in the unit of the file.
struct CopcInfo {
  Vec3 centre;
  double halfsize = 0;
  double spacing = 0;  ///< of the points of level 0; half as wide each level down
  uint64_t page_offset = 0, page_bytes = 0;
  double gps_min = 0, gps_max = 0;
};
/// A node: cells of level l have the edge 2 halfsize / 2^l and are numbered from the low corner.
struct CopcKey {
  int32_t level = 0, x = 0, y = 0, z = 0;
};
struct CopcEntry {
  CopcKey key;
  uint64_t offset = 0;
  int32_t bytes = 0;
  int32_t points = 0;  ///< -1: offset and bytes are of a page
};

bool is_copc_record(const Record& record);
/// nullopt of files that are none; Error(kFormat) where the record cannot be.
std::optional<CopcInfo> copc_info(const ByteSource& source, const std::vector<Record>& vlrs);
std::vector<std::byte> info_bytes(const CopcInfo& info);
void put_entry(std::byte* to, const CopcEntry& entry);

/// What of a file is wanted, in its unit.
struct CopcPart {
  Box3 box;  ///< nodes that it touches
  int most_level = kMostCopcLevel;
};
/// The coarsest level whose points stand no wider apart than this.
int level_of(const CopcInfo& info, double spacing);
/// The chunks of the wanted nodes in the order of the file, found without reading points or the pages
/// of nodes that are not wanted. Refuses entries that the file has no room for, pages that come back
/// to themselves and nodes that share bytes.
std::vector<LazChunk> copc_chunks(const ByteSource& source, const Header& header,
                                  const CopcInfo& info, const CopcPart& part, Task& task);

}  // namespace jalon::las
