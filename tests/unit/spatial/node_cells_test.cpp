// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/node_cells.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "base/random.h"

using namespace jalon;

namespace {

std::vector<NodeCell> drawn_cells(size_t count, int64_t extent, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<NodeCell> cells;
  const auto draw = [&] {
    return static_cast<int64_t>(random.uniform() * static_cast<double>(extent));
  };
  for (size_t i = 0; i < count; ++i) cells.push_back({draw() - extent / 2, draw() - extent / 2});
  return cells;
}

}  // namespace

TEST_CASE("node_cells__are_ordered_alike_near_and_beyond_what_one_number_holds") {
  Task task;
  for (const int64_t extent : {int64_t{7}, int64_t{1000}, int64_t{1} << 59}) {
    CAPTURE(extent);
    const auto cells = drawn_cells(500, extent, 3);
    std::vector<uint32_t> by_hand(cells.size());
    std::iota(by_hand.begin(), by_hand.end(), 0u);
    std::stable_sort(by_hand.begin(), by_hand.end(),
                     [&](uint32_t a, uint32_t b) { return cells[a] < cells[b]; });
    CHECK(order_of_cells(cells, task) == by_hand);
  }
  CHECK(order_of_cells({}, task).empty());
}

TEST_CASE("node_cells__bits_tell_what_the_table_does_until_a_node_is_cleared") {
  constexpr int64_t kMargin = 4;
  auto cells = drawn_cells(300, 40, 5);
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  const NodeTable table(cells);
  NodeBits bits(cells, kMargin);
  REQUIRE(bits.known());
  const auto agree = [&](const NodeCell& about, const NodeCell* gone) {
    for (int64_t reach = 0; reach <= kMargin; ++reach)
      for (int64_t c = -kMargin; c <= kMargin; ++c) {
        const uint64_t window = bits.window(about, c, reach);
        for (int64_t r = -reach; r <= reach; ++r) {
          const NodeCell cell{about.column + c, about.row + r};
          const bool there =
              table.at(cell) != NodeTable::kNoNode && (gone == nullptr || cell != *gone);
          if ((window >> (r + reach) & 1) != (there ? 1u : 0u)) return false;
        }
        if (window >> (2 * reach + 1) != 0) return false;
      }
    return true;
  };
  for (const NodeCell& cell : cells) CHECK(agree(cell, nullptr));
  bits.clear(cells[7]);
  CHECK(agree(cells[7], &cells[7]));
  CHECK(agree(cells[8], &cells[7]));
}

TEST_CASE("node_cells__far_apart_have_no_bits") {
  const std::vector<NodeCell> far{{0, 0}, {int64_t{1} << 60, 5}};
  CHECK_FALSE(NodeBits(far, 2).known());
  const std::vector<NodeCell> wide{{0, 0}, {100, 100}};
  CHECK_FALSE(NodeBits(wide, 2).known());
  CHECK_FALSE(NodeBits(std::vector<NodeCell>{{0, 0}}, NodeBits::kMostMargin + 1).known());
  CHECK_FALSE(NodeBits({}, 2).known());
}
