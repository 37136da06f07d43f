// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/task.h"
#include "formats/ept/index.h"
#include "formats/files/byte_source.h"
#include "formats/las/copc.h"

namespace jalon::ept {

struct Node {
  las::CopcKey key;
  uint64_t points = 0;
};

/// A file of one of the folders beside the index.
std::string file_beside(const std::string& index, const char* folder, const std::string& name);
/// The nodes with points that the box touches, down to this level, in the order of levels and cells, found without
/// files of the hierarchy that are not wanted. Refuses files that come back to themselves, nodes that stand twice and
/// files of points that have not the bytes of the points.
std::vector<Node> wanted_nodes(const ByteSource& source, const Index& index, const Box3& box,
                               int most_level, Task& task);

}  // namespace jalon::ept
