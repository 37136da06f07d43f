// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The tree of parts against trees drawn at random and taken apart, and against the limits of its depth.
#include "formats/city/tree.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "unit/formats/city/json_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

city::Draft draft_named(const std::string& name, uint64_t number = city::kNoNumber) {
  city::Draft draft;
  draft.part.name = name;
  draft.number = number;
  return draft;
}

struct BuiltTree {
  bool is_tree = false;
  std::vector<Part> parts;
  std::vector<uint32_t> new_index;
};
BuiltTree built(city::Tree& tree) {
  BuiltTree out;
  out.is_tree = tree.build(out.parts, out.new_index);
  return out;
}

/// A chain of parts without numbers, each below the next one: the deepest stands first.
city::Tree chain(uint32_t levels) {
  city::Tree tree;
  for (uint32_t i = 0; i < levels; ++i) {
    city::Draft draft = draft_named(std::to_string(i));
    if (i + 1 < levels) draft.parent = i + 1;
    tree.add(std::move(draft));
  }
  return tree;
}

}  // namespace

TEST_CASE("city_tree__numbered_parts_stand_in_the_order_of_their_numbers") {
  RandomStream random(1, 1);
  for (int round = 0; round < 20; ++round) {
    constexpr uint32_t kParts = 30;
    std::vector<uint32_t> order(kParts), parent(kParts, kNoPart);
    std::iota(order.begin(), order.end(), 0u);
    for (uint32_t i = kParts; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    for (uint32_t i = 1; i < kParts; ++i) parent[i] = static_cast<uint32_t>(random.below(i));
    city::Tree tree;
    const uint32_t group = tree.add(draft_named("group"));  // an object that only holds others
    std::vector<uint32_t> index;
    for (const uint32_t number : order) {
      city::Draft draft = draft_named("part " + std::to_string(number), number);
      draft.parent = group;  // the number tells where it belongs, not the object
      if (number != 0) draft.above = parent[number];
      if (number % 3 == 1) draft.copied_from = number - 1;
      index.push_back(tree.add(draft));
      CHECK(tree.add(draft_named("again", number)) == index.back());
    }
    const BuiltTree got = built(tree);
    REQUIRE(got.is_tree);
    REQUIRE(got.parts.size() == kParts);
    CHECK(got.new_index[group] == kNoPart);
    for (uint32_t i = 0; i < kParts; ++i) CHECK(got.new_index[index[i]] == order[i]);
    for (uint32_t p = 0; p < kParts; ++p) {
      CHECK(got.parts[p].name == "part " + std::to_string(p));
      CHECK(got.parts[p].parent == (p == 0 ? kNoParent : parent[p]));
      CHECK(got.parts[p].copied_from == (p % 3 == 1 ? p - 1 : kNoParent));
    }
  }
}

TEST_CASE("city_tree__a_gap_or_a_face_without_number_leaves_the_parts_as_they_came") {
  for (const bool gap : {true, false}) {
    city::Tree tree;
    city::Draft wall = draft_named("wall", gap ? 2 : 1);
    wall.above = 0;
    tree.add(wall);
    tree.add(draft_named("building", 0));
    city::Draft other = draft_named("other");
    other.parent = 0;
    other.faces_seen = gap ? 0 : 1;
    tree.add(other);
    const BuiltTree got = built(tree);
    REQUIRE(got.is_tree);
    CHECK(got.new_index == std::vector<uint32_t>{0, 1, 2});
    REQUIRE(got.parts.size() == 3);
    CHECK(got.parts[0].parent == 1);  // part_of still counts
    CHECK(got.parts[1].parent == kNoParent);
    CHECK(got.parts[2].parent == 0);
  }
}

TEST_CASE("city_tree__has_64_levels_at_most_and_no_ring") {
  city::Tree highest = chain(64);
  const BuiltTree whole = built(highest);
  CHECK(whole.is_tree);
  CHECK(whole.parts[0].parent == 1);
  city::Tree too_high = chain(65);
  CHECK_FALSE(built(too_high).is_tree);
  for (const uint32_t back : {0u, 3u, 9u}) {
    city::Tree ring = chain(10);
    ring.at(9).parent = back;
    CHECK_FALSE(built(ring).is_tree);
  }
}

TEST_CASE(
    "city_tree__attributes_of_other_kinds_are_skipped_and_a_class_counts_with_a_number_only") {
  const auto read = [](const std::string& text) {
    JsonFile file(text);
    const city::Piece piece = file.piece();
    JsonCursor cursor = piece.cursor();
    city::Draft draft;
    std::string others;
    city::read_attributes(cursor, draft, [&](const std::string& name) {
      others += name + ";";
      return false;
    });
    cursor.end();
    return std::pair(draft, others);
  };
  const auto [full, unknown] = read(
      R"({"name": "a", "part": 4, "class": "wall", "part_of": 2, "copied_from": 1, "evidence": "copied",
          "level_of_detail": 3, "width_m": 1.5, "height_m": 2.5, "depth_m": -0.25, "sigma_m": 0.002,
          "face": [7, 8], "closes_opening": true, "colour": {"deep": [1, {"x": 2}]}})");
  CHECK(unknown == "colour;");
  CHECK(full.number == 4);
  CHECK(full.part.part_class == "wall");
  CHECK(full.above == 2);
  CHECK(full.copied_from == 1);
  CHECK(full.part.evidence == Evidence::kCopied);
  CHECK(full.part.level_of_detail == 3);
  CHECK(full.part.depth_m == -0.25);
  CHECK(full.is_closing);
  CHECK(full.face_ids == std::vector<uint32_t>{7, 8});
  CHECK(full.sigmas_m == std::vector<double>{0.002});

  const auto [hostile, skipped] = read(
      R"({"part": -1, "part_of": 1e300, "copied_from": "1", "class": "wall", "level_of_detail": 4,
          "width_m": null, "evidence": "guessed", "face": [1, "x", -5, 1e12, null, 2],
          "closes_opening": 1, "name": ["a"], "sigma_m": {}})");
  CHECK(skipped == "copied_from;width_m;closes_opening;name;sigma_m;");
  CHECK(hostile.number == city::kNoNumber);
  CHECK(hostile.above == city::kNoNumber);
  CHECK(hostile.part.part_class.empty());
  CHECK(hostile.part.level_of_detail == 0);
  CHECK(hostile.part.evidence == Evidence::kNone);
  CHECK(std::isnan(hostile.part.width_m));
  CHECK(hostile.face_ids == std::vector<uint32_t>{1, 0, 0, 2});
  CHECK_FALSE(hostile.is_closing);
}
