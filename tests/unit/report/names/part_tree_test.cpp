// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Trees of parts with random parents, rings and wild indices among them, against walks up the chains.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/random.h"
#include "report/names/part_tree.h"

using namespace jalon;

namespace {

Model parts_under(const std::vector<uint64_t>& parents) {
  Model out;
  for (const uint64_t parent : parents) {
    Part part;
    part.parent = parent;
    out.parts.push_back(part);
  }
  return out;
}

// Is this part among the ancestors of another, itself included? The chain is followed once around at most.
bool stands_above(const std::vector<uint64_t>& parents, uint64_t above, uint64_t part) {
  for (size_t steps = 0; part < parents.size() && steps <= parents.size(); ++steps) {
    if (part == above) return true;
    part = parents[part];
  }
  return false;
}

// Every part once, parents before their children and a step above them, the children of one in their order.
void check_walk(const PartTree& tree, size_t parts) {
  REQUIRE(tree.walk().size() == parts);
  std::vector<bool> seen(parts, false);
  std::vector<uint32_t> path;  // from the root
  for (const PartTree::Step& step : tree.walk()) {
    REQUIRE(step.part < parts);
    CHECK(!seen[step.part]);
    seen[step.part] = true;
    REQUIRE(step.depth <= path.size());
    if (step.depth < path.size()) CHECK(path[step.depth] < step.part);  // the sibling before
    path.resize(step.depth);
    path.push_back(step.part);
    for (const uint32_t above : path) CHECK(tree.is_below(step.part, above));
    if (path.size() > 1)
      CHECK(tree.nearest(step.part, [&](uint32_t p) { return p != step.part; }) ==
            path[path.size() - 2]);
    else CHECK(tree.nearest(step.part, [&](uint32_t p) { return p != step.part; }) == kNoPart);
  }
}

}  // namespace

TEST_CASE("part_tree__walks_random_forests_from_the_roots_down") {
  RandomStream random(1, 0);
  for (int trial = 0; trial < 100; ++trial) {
    CAPTURE(trial);
    // Parents stand anywhere but make no ring: they follow a shuffled order.
    std::vector<uint64_t> parents(1 + random.below(25)), order(parents.size());
    for (size_t i = 0; i < order.size(); ++i) {
      order[i] = i;
      std::swap(order[i], order[random.below(i + 1)]);
    }
    for (size_t i = 0; i < order.size(); ++i) {
      const uint64_t above = random.below(i + 2);
      parents[order[i]] = above < i ? order[above] : kNoParent;
    }
    const Model model = parts_under(parents);
    const PartTree tree(model);
    check_walk(tree, parents.size());
    for (uint32_t a = 0; a < parents.size(); ++a)
      for (uint32_t b = 0; b < parents.size(); ++b)
        CHECK(tree.is_below(a, b) == stands_above(parents, b, a));
  }
}

TEST_CASE("part_tree__rings_are_opened_at_one_parent_each_and_wild_parents_are_none") {
  // A ring of three with a tail, one that is its own parent, one whose parent is no part, a ring of two.
  const std::vector<uint64_t> parents{1, 2, 0, 0, 4, 77, 7, 6};
  const PartTree tree(parts_under(parents));
  check_walk(tree, parents.size());
  size_t roots = 0;
  for (const PartTree::Step& step : tree.walk()) roots += step.depth == 0;
  CHECK(roots == 4);
  CHECK(tree.is_below(3, 0));
  RandomStream random(2, 0);
  for (int trial = 0; trial < 200; ++trial) {
    CAPTURE(trial);
    std::vector<uint64_t> wild(1 + random.below(12));
    for (uint64_t& parent : wild) parent = random.below(wild.size() + 2);
    const PartTree opened(parts_under(wild));
    check_walk(opened, wild.size());
    // As many roots as chains that end, and rings: the rings counted by their smallest part.
    size_t wanted = 0, found = 0;
    for (size_t i = 0; i < wild.size(); ++i) {
      const bool is_end = wild[i] >= wild.size();
      bool is_smallest = !is_end && stands_above(wild, i, wild[i]);
      for (size_t k = 0; k < i; ++k)
        is_smallest = is_smallest && !(stands_above(wild, k, i) && stands_above(wild, i, k));
      wanted += is_end || is_smallest;
    }
    for (const PartTree::Step& step : opened.walk()) found += step.depth == 0;
    CHECK(found == wanted);
  }
}

TEST_CASE("part_tree__faces_are_listed_by_their_part_and_strays_are_left_out") {
  Model model = parts_under({kNoParent, 0, 0});
  for (const uint32_t part : {2u, 0u, 2u, 9u, kNoPart, 2u}) {
    Face face;
    face.part = part;
    model.faces.push_back(face);
  }
  const PartTree tree(model);
  REQUIRE(tree.faces().size() == 3);
  CHECK(tree.faces()[0] == std::vector<size_t>{1});
  CHECK(tree.faces()[1].empty());
  CHECK(tree.faces()[2] == std::vector<size_t>{0, 2, 5});
}

TEST_CASE("part_tree__parts_are_called_by_their_names_or_numbers") {
  Model model = parts_under({kNoParent, 0});
  model.parts[0].name = "north wing";
  CHECK(part_label(model, 0) == "north wing");
  CHECK(part_label(model, 1) == "part 1");
  CHECK(part_label(model, 2).empty());
  CHECK(part_label(model, kNoParent).empty());
}
