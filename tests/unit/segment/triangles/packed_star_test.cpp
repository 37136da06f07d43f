// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/packed_star.h"

#include <doctest/doctest.h>

using namespace jalon;

namespace {

using StarPairs = std::vector<std::pair<uint32_t, uint32_t>>;

// What a star gives back, the smaller corner of each pair first.
StarPairs read_pairs(const std::vector<uint32_t>& star) {
  StarPairs out;
  for_each_pair(star,
                [&](uint32_t a, uint32_t b) { out.emplace_back(std::min(a, b), std::max(a, b)); });
  return out;
}

std::vector<uint32_t> star_of(const StarPairs& pairs) {
  std::vector<uint32_t> star;
  StarWriter writer(star);
  for (const auto& [a, b] : pairs) writer.add(a, b);
  return star;
}

}  // namespace

TEST_CASE("packed_star__all_round_takes_one_number_a_triangle_and_one_more") {
  const StarPairs ring = {{1, 7}, {3, 7}, {3, 9}, {4, 9}, {4, 5}, {1, 5}};
  const std::vector<uint32_t> star = star_of(ring);
  CHECK(star.size() == 7);
  CHECK(read_pairs(star) == ring);
}

TEST_CASE("packed_star__keeps_the_order_of_fans_that_go_on_at_their_other_end_or_break_off") {
  const StarPairs pairs = {{2, 8}, {3, 8}, {2, 6}, {5, 6}, {1, 5}, {10, 11}};
  const std::vector<uint32_t> star = star_of(pairs);
  CHECK(read_pairs(star) == pairs);
  CHECK(star.size() < 2 * pairs.size());
  CHECK(star_of({}).empty());
  CHECK(read_pairs(star_of({{1, 2}, {3, 4}, {1, 3}})) == StarPairs{{1, 2}, {3, 4}, {1, 3}});
}

TEST_CASE("packed_star__has_its_triangles_alone") {
  const std::vector<uint32_t> star = star_of({{1, 2}, {2, 3}, {5, 6}});
  CHECK(star_has(star, 2, 1));
  CHECK(star_has(star, 2, 3));
  CHECK(star_has(star, 6, 5));
  CHECK_FALSE(star_has(star, 1, 3));
  CHECK_FALSE(star_has(star, 3, 5));
}
