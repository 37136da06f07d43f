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
  return las::CopcKey{cell[0], cell[1], cell[2], cell[3]};
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
    const ByteSource file(file_beside(source_.path(), kHierarchyFolder, name + ".json"));
    const std::vector<JsonValue> json = json_of(file);
    if (json.front().kind != JsonValue::Kind::kObject) file.refuse(0, "no object of nodes");
    for (const JsonValue& node : JsonChildren(json.front())) {
      const auto key = key_of(node.name);
      if (!key || node.kind != JsonValue::Kind::kInteger || node.integer < -1)
        file.refuse(0, "\"%.60s\" is no node of an octree", node.name.c_str());
      if (key->level > most_level_ || !touches(index_, *key, box_)) continue;
      if (node.integer == -1) {
        if (node.name == name) file.refuse(0, "the node %s is in its own file", name.c_str());
        if (!opened_.try_emplace(node.name).second)
          file.refuse(0, "the file of the node %s comes twice", node.name.c_str());
        files.push_back(node.name);
      } else if (!found_
                      .try_emplace({key->level, key->x, key->y, key->z},
                                   static_cast<uint64_t>(node.integer))
                      .second) {
        file.refuse(0, "the node %s comes twice", node.name.c_str());
      }
    }
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
