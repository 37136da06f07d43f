// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/dxf/placing.h"

#include <doctest/doctest.h>

#include <numbers>

#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::dxf;
using namespace jalon::test;

namespace {

struct Placed {
  std::vector<Loop> loops;
  std::vector<Patch> patches;
  std::vector<std::string> missing;
};

Placed placed(const Shapes& shapes, const Blocks& blocks) {
  Placed out;
  Task task;
  place(shapes, blocks,
        {[&](Loop loop) { out.loops.push_back(std::move(loop)); },
         [&](Patch patch) { out.patches.push_back(std::move(patch)); },
         [&](const std::string& name) { out.missing.push_back(name); }},
        {"a.dxf", 1000}, task);
  return out;
}

Shapes half_disc(const std::string& layer) {
  Shapes out;
  out.base = {1, 0, 0};
  out.loops.push_back({layer, {{0, 0, 0}, {2, 0, 0}}, {0, 1}, {0, 0, 1}, {}});
  return out;
}

}  // namespace

TEST_CASE("dxf_placing__a_block_is_scaled_turned_and_moved_from_its_base_point") {
  Shapes drawing;
  Insert insert;
  insert.layer = "A", insert.block = "Arch", insert.at = {10, 20, 5}, insert.scale = {2, 2, 2};
  insert.rotation_rad = std::numbers::pi / 2;
  drawing.inserts = {insert};
  const Placed out = placed(drawing, {{"arch", half_disc("0")}});
  REQUIRE(out.loops.size() == 1);
  CHECK(norm(out.loops[0].corners[0] - Vec3{10, 18, 5}) < 1e-12);
  CHECK(norm(out.loops[0].corners[1] - Vec3{10, 22, 5}) < 1e-12);
  CHECK(out.loops[0].bulges == std::vector<double>{0, 1});  // still an arc
  CHECK(out.loops[0].layer == "A");                         // layer 0 is that of the insert
}

TEST_CASE("dxf_placing__arcs_become_chords_where_two_scales_differ_and_keep_their_layer") {
  Shapes drawing;
  Insert insert;
  insert.block = "arch", insert.scale = {2, 1, 1};
  drawing.inserts = {insert};
  const Placed out = placed(drawing, {{"arch", half_disc("W")}});
  REQUIRE(out.loops.size() == 1);
  CHECK(out.loops[0].corners.size() > 8);
  CHECK(out.loops[0].layer == "W");
  for (const double b : out.loops[0].bulges) CHECK(b == 0);
}

TEST_CASE("dxf_placing__mirrored_blocks_keep_the_side_of_their_arcs") {
  Shapes drawing;
  Insert insert;
  insert.block = "arch", insert.scale = {-1, 1, 1};
  drawing.inserts = {insert};
  const Placed out = placed(drawing, {{"arch", half_disc("0")}});
  // Seen against its normal the loop runs as before: the normal is turned over with it.
  CHECK(out.loops[0].normal == Vec3{0, 0, -1});
  CHECK(out.loops[0].bulges == std::vector<double>{0, 1});
}

TEST_CASE("dxf_placing__rows_and_columns_blocks_within_blocks_and_those_that_are_not_there") {
  Shapes drawing, row;
  Insert inner, outer;
  inner.block = "arch", inner.columns = 3, inner.column_step = 10;
  row.inserts = {inner};
  outer.block = "row", outer.rows = 2, outer.row_step = 100;
  drawing.inserts = {outer};
  Insert lost;
  lost.block = "lost";
  drawing.inserts.push_back(lost);
  const Placed out = placed(drawing, {{"arch", half_disc("0")}, {"row", row}});
  REQUIRE(out.loops.size() == 6);
  CHECK(norm(out.loops[5].corners[0] - Vec3{19, 100, 0}) < 1e-12);
  CHECK(out.missing == std::vector<std::string>{"lost"});
}

TEST_CASE("dxf_placing__blocks_without_end_are_refused") {
  Shapes self;
  Insert insert;
  insert.block = "self";
  self.inserts = {insert};
  CHECK(failure_of([&] { placed(self, {{"self", self}}); }).status == Status::kFormat);
  // Ten thousand million small ones by six levels of arrays.
  Blocks blocks{{"0", half_disc("0")}};
  for (int level = 1; level <= 6; ++level) {
    Insert many;
    many.block = std::to_string(level - 1), many.columns = 100;
    blocks[std::to_string(level)].inserts = {many};
  }
  Shapes drawing;
  Insert top;
  top.block = "6";
  drawing.inserts = {top};
  CHECK(failure_of([&] { placed(drawing, blocks); }).status == Status::kLimit);
}

TEST_CASE("dxf_placing__what_has_no_corners_counts_where_it_is_repeated") {
  // A million times a thousand of what shows nothing: blocks that are not there, outlines without corners.
  constexpr size_t kEach = 1000;
  Insert lost;
  lost.block = "lost";
  Shapes inserts, outlines;
  inserts.inserts.assign(kEach, lost);
  outlines.loops.assign(kEach, Loop{"0", {}, {}, {0, 0, 1}, {}});
  for (const Shapes& shapes : {inserts, outlines}) {
    Insert many;
    many.block = "b", many.columns = 1000, many.rows = 1000;
    Shapes drawing;
    drawing.inserts = {many};
    CHECK(failure_of([&] { placed(drawing, {{"b", shapes}}); }).status == Status::kLimit);
  }
}
