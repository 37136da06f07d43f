// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Queries in groups at the edges of the sort's stretches: of 256 positions, wider ones from 4096 of them on.
#include "compare/distance/nearest_groups.h"

#include <doctest/doctest.h>

#include <vector>

#include "spatial/octree/octree.h"

using namespace jalon;

TEST_CASE("nearest_groups__at_the_edges_of_stretches_hold_their_queries_and_the_others_none") {
  for (const uint32_t references : {1U, 255U, 256U, 257U, 1U << 20, (1U << 20) + 1}) {
    // Both ends and both sides of a border, twice over, with queries in between that found nothing.
    const uint32_t border = references / 2 / 256 * 256, last = references - 1;
    const uint32_t wanted[] = {0, last, border, border > 0 ? border - 1 : 0};
    std::vector<uint32_t> nearest;
    for (int turn = 0; turn < 2; ++turn)
      for (const uint32_t position : wanted) nearest.insert(nearest.end(), {position, kNoPoint});
    Task task;
    const NearestGroups groups(nearest, references, task);
    size_t seen = 0;
    for (const uint32_t position : wanted) {
      std::vector<uint32_t> expected;
      for (uint32_t q = 0; q < nearest.size(); ++q)
        if (nearest[q] == position) expected.push_back(q);
      const auto group = groups[position];
      CHECK(std::vector<uint32_t>(group.begin(), group.end()) == expected);
    }
    for (uint32_t position = 0; position < references; ++position) seen += groups[position].size();
    CHECK(seen == 8);
  }
}

TEST_CASE("nearest_groups__of_no_queries_or_none_that_found_anything_are_empty") {
  Task task;
  const std::vector<uint32_t> none, nothing(1000, kNoPoint);
  for (const auto& nearest : {none, nothing}) {
    const NearestGroups groups(nearest, 300, task);
    for (size_t position = 0; position < 300; ++position) CHECK(groups[position].empty());
  }
}

TEST_CASE("nearest_groups__are_the_same_for_any_threads_where_all_queries_are_of_one_point") {
  const std::vector<uint32_t> nearest(100000, 4567);
  for (const unsigned threads : {1U, 3U}) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    const NearestGroups groups(nearest, 9000, task);
    const auto group = groups[4567];
    REQUIRE(group.size() == nearest.size());
    for (uint32_t q = 0; q < nearest.size(); ++q) REQUIRE(group[q] == q);
    CHECK(groups[4566].empty());
    CHECK(groups[4568].empty());
  }
}
