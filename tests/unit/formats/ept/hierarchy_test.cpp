// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/hierarchy.h"

#include <doctest/doctest.h>

#include <map>

#include "base/json_reader.h"

using namespace jalon;

namespace {

using Nodes = std::vector<las::CopcTree::Node>;

// Down one corner, with a neighbour at each level.
Nodes branch(int levels) {
  Nodes out = {{{0, 0, 0, 0}, 0, 7}};
  for (int l = 1; l < levels; ++l) {
    out.push_back({{l, 0, 0, 0}, 0, static_cast<size_t>(10 * l)});
    out.push_back({{l, 1, 0, 1}, 0, static_cast<size_t>(10 * l + 1)});
  }
  return out;
}

std::map<std::string, std::map<std::string, int64_t>> read_all(
    const std::vector<ept::HierarchyFile>& files) {
  std::map<std::string, std::map<std::string, int64_t>> out;
  for (const ept::HierarchyFile& file : files) {
    const std::vector<JsonValue> json = read_json(file.json);
    for (const JsonValue& member : JsonChildren(json.front()))
      CHECK(out[file.name].try_emplace(member.name, member.integer).second);
  }
  return out;
}

}  // namespace

TEST_CASE("ept_hierarchy__few_nodes_stand_in_one_file_under_their_names") {
  const auto files = read_all(ept::hierarchy_files(branch(14)));
  REQUIRE(files.size() == 1);
  CHECK(files.at("0-0-0-0").size() == 27);
  CHECK(files.at("0-0-0-0").at("13-1-0-1") == 131);
  CHECK(ept::name_of({3, 1, 2, 4}) == "3-1-2-4");
}

TEST_CASE("ept_hierarchy__many_are_cut_where_a_node_has_children_and_all_are_found_once") {
  const Nodes nodes = branch(14);
  const auto files = read_all(ept::hierarchy_files(nodes, 26));
  REQUIRE(files.size() == 3);
  CHECK(files.at("0-0-0-0").at("6-0-0-0") == -1);
  CHECK(files.at("0-0-0-0").at("6-1-0-1") == 61);  // nothing below it
  CHECK(files.at("6-0-0-0").at("6-0-0-0") == 60);
  CHECK(files.at("6-0-0-0").at("12-0-0-0") == -1);
  CHECK(files.at("12-0-0-0").at("13-0-0-0") == 130);
  int64_t sum = 0, expected = 0;
  for (const auto& [name, members] : files)
    for (const auto& [key, count] : members) sum += count < 0 ? 0 : count;
  for (const las::CopcTree::Node& node : nodes) expected += static_cast<int64_t>(node.count);
  CHECK(sum == expected);
}

TEST_CASE("ept_hierarchy__no_points_are_an_empty_root") {
  const auto files = ept::hierarchy_files({});
  REQUIRE(files.size() == 1);
  CHECK(files[0].name == "0-0-0-0");
  CHECK(files[0].json == "{\"0-0-0-0\":0}");
}
