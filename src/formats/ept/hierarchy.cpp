// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/hierarchy.h"

#include <array>
#include <map>
#include <set>

#include "base/json_writer.h"

namespace jalon::ept {

namespace {

constexpr int kLevelsOfFile = 6;  // a surface has about 4^6 nodes in them

using Cell = std::array<int32_t, 4>;  // level first: files in the order of their levels

Cell cell_of(const las::CopcKey& key) { return {key.level, key.x, key.y, key.z}; }

Cell ancestor_of(const Cell& cell, int level) {
  const int up = cell[0] - level;
  return {level, cell[1] >> up, cell[2] >> up, cell[3] >> up};
}

std::string name_of_cell(const Cell& cell) { return name_of({cell[0], cell[1], cell[2], cell[3]}); }

}  // namespace

std::string name_of(const las::CopcKey& key) {
  std::string out = std::to_string(key.level);
  for (const int32_t n : {key.x, key.y, key.z}) out.append("-").append(std::to_string(n));
  return out;
}

std::vector<HierarchyFile> hierarchy_files(std::span<const las::CopcTree::Node> nodes,
                                           size_t most) {
  std::set<Cell> parents;  // where files may be cut
  if (nodes.size() > most)
    for (const las::CopcTree::Node& node : nodes)
      if (node.key.level % kLevelsOfFile == 1)
        parents.insert(ancestor_of(cell_of(node.key), node.key.level - 1));
  std::map<Cell, JsonWriter> files;
  files[Cell{}].begin_object();
  for (const las::CopcTree::Node& node : nodes) {
    const Cell cell = cell_of(node.key);
    const int level = cell[0];
    Cell root{};
    for (int top = 0; nodes.size() > most && top + kLevelsOfFile < level; top += kLevelsOfFile)
      root = ancestor_of(cell, top + kLevelsOfFile);
    if (level > 0 && parents.contains(cell)) {
      files[root].name(name_of(node.key)).value(-1);
      files[root = cell].begin_object();
    }
    files[root].name(name_of(node.key)).value(node.count);
  }
  if (nodes.empty()) files[Cell{}].name(name_of({})).value(0);
  std::vector<HierarchyFile> out;
  for (auto& [cell, json] : files) out.push_back({name_of_cell(cell), json.end_object().take()});
  return out;
}

}  // namespace jalon::ept
