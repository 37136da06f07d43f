// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "formats/las/copc_tree.h"

namespace jalon::ept {

/// "D-X-Y-Z": level and cell of a node.
std::string name_of(const las::CopcKey& key);

/// A file of ept-hierarchy: the nodes below a root and how many points each has.
struct HierarchyFile {
  std::string name;  ///< without extension
  std::string json;
};
constexpr size_t kMostNodes = 20000;  ///< of one file: some 400 KB, which a viewer loads at once

/// Up to `most` nodes stand in one file. More are cut every six levels: there a node that has children is -1, and
/// a file of its name tells of it and of what is below. Nodes: level by level, as copc_tree() gives them.
std::vector<HierarchyFile> hierarchy_files(std::span<const las::CopcTree::Node> nodes,
                                           size_t most = kMostNodes);

}  // namespace jalon::ept
