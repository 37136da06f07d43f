// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/nodes.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "formats/ept/data_set.h"
#include "formats/ept/hierarchy.h"
#include "formats/files/utf8.h"

namespace jalon::ept {

namespace {

using NodeCell = std::array<int32_t, 4>;  // level first

// Only what name_of() writes: no name leads out of the folder.
std::optional<las::CopcKey> key_of(const std::string& name) {
  NodeCell cell{};
  const char* at = name.data();
  const char* const end = at + name.size();
  for (size_t k = 0; k < cell.size(); ++k) {
    if (k != 0 && (at == end || *at++ != '-')) return std::nullopt;
    const auto [next, error] = std::from_chars(at, end, cell[k]);
    if (error != std::errc{} || cell[k] < 0) return std::nullopt;
    at = next;
  }
  if (at != end || cell[0] > las::kMostCopcLevel - 1) return std::nullopt;
  for (size_t k = 1; k < cell.size(); ++k)
    if (cell[k] >> cell[0] != 0) return std::nullopt;
  const las::CopcKey key{cell[0], cell[1], cell[2], cell[3]};
  if (name_of(key) != name) return std::nullopt;  // "00", "-0"
  return key;
}

// A step of rounding wider than the cell: the points on its faces are told by others' arithmetic.
bool touches(const Index& index, const las::CopcKey& key, const Box3& box) {
  constexpr double kSlack = 1e-6;  // of the cube
  const double edge = std::ldexp(index.edge, -key.level), slack = kSlack * index.edge;
  const int32_t cell[] = {key.x, key.y, key.z};
  for (int k = 0; k < 3; ++k) {
    const double low = index.low[k] + edge * cell[k];
    if (low - slack > box.max[k] || low + edge + slack < box.min[k]) return false;
  }
  return true;
}

class Walk {
 public:
  Walk(const ByteSource& source, const Index& index, const Box3& box, int most_level, Task& task)
      : source_(source), index_(index), box_(box), most_level_(most_level), task_(task) {}

  std::vector<Node> run() {
    std::vector<std::string> files = {name_of({})};
    while (!files.empty()) {
      task_.checkpoint(0);
      const std::string name = std::move(files.back());
      files.pop_back();
      read_file(name, files);
    }
    std::vector<Node> out;
    for (const auto& [cell, points] : found_)
      if (points > 0) out.push_back({{cell[0], cell[1], cell[2], cell[3]}, points});
    return out;
  }

 private:
  void read_file(const std::string& name, std::vector<std::string>& files) {
    const ByteSource source(file_beside(source_.path(), kHierarchyFolder, name + ".json"));
    const JsonFile file(source, task_);
    JsonCursor json = file.cursor();
    json.begin_object();
    for (std::string node; json.next_member(node);) {
      const auto key = key_of(node);
      const int64_t points = json.integer();
      if (!key || points < -1)
        source.refuse(json.byte(), "\"%.60s\" is no node of an octree",
                      name_from_file(node, "node").c_str());
      if (key->level > most_level_ || !touches(index_, *key, box_)) continue;
      if (points == -1) {
        if (node == name)
          source.refuse(json.byte(), "the node %s is in its own file", name.c_str());
        if (!opened_.try_emplace(node).second)
          source.refuse(json.byte(), "the file of the node %s comes twice", node.c_str());
        files.push_back(node);
      } else if (!found_
                      .try_emplace({key->level, key->x, key->y, key->z},
                                   static_cast<uint64_t>(points))
                      .second) {
        source.refuse(json.byte(), "the node %s comes twice", node.c_str());
      }
    }
    json.end();
  }

  const ByteSource& source_;
  const Index& index_;
  const Box3& box_;
  int most_level_;
  Task& task_;
  std::map<std::string, int> opened_{{name_of({}), 0}};
  std::map<NodeCell, uint64_t> found_;
};

}  // namespace

std::string file_beside(const std::string& index, const char* folder, const std::string& name) {
  return index.substr(0, index.find_last_of("/\\") + 1) + folder + "/" + name;
}

std::vector<Node> wanted_nodes(const ByteSource& source, const Index& index, const Box3& box,
                               int most_level, Task& task) {
  std::vector<Node> nodes = Walk(source, index, box, most_level, task).run();
  for (const Node& node : nodes) {
    task.checkpoint(0);
    const ByteSource file(file_beside(source.path(), kDataFolder, name_of(node.key) + ".bin"));
    if (file.size() % index.record_bytes != 0 || file.size() / index.record_bytes != node.points)
      file.refuse(file.size(), "%llu points of %zu bytes were expected",
                  static_cast<unsigned long long>(node.points), index.record_bytes);
  }
  return nodes;
}

}  // namespace jalon::ept
