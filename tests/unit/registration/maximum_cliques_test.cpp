// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/maximum_cliques.h"

#include <doctest/doctest.h>

using namespace jalon;

namespace {

std::vector<uint64_t> all_of(const PairGraph& graph) {
  std::vector<uint64_t> out(graph.words(), 0);
  for (size_t i = 0; i < graph.nodes(); ++i) out[i / 64] |= uint64_t{1} << (i % 64);
  return out;
}

/// Groups of nodes; nodes of different groups are joined (Moon & Moser 1965).
PairGraph grouped(size_t groups, size_t of_each) {
  PairGraph graph(groups * of_each);
  for (size_t i = 0; i < graph.nodes(); ++i)
    for (size_t j = 0; j < i; ++j)
      if (i / of_each != j / of_each) graph.join(i, j);
  return graph;
}

}  // namespace

TEST_CASE("cliques__of_joined_groups_take_one_node_of_each_in_every_way") {
  const PairGraph graph = grouped(4, 3);
  Task task;
  const Cliques found = maximum_cliques(graph, all_of(graph), 1, 1000, task);
  CHECK(found.complete);
  REQUIRE(found.all.size() == 81);
  for (size_t i = 0; i < found.all.size(); ++i) {
    REQUIRE(found.all[i].size() == 4);
    for (size_t k = 0; k < 4; ++k) CHECK(found.all[i][k] / 3 == k);
    if (i > 0) CHECK(found.all[i - 1] < found.all[i]);
  }
}

TEST_CASE("cliques__say_that_there_are_more_than_were_asked_for") {
  const PairGraph graph = grouped(3, 2);
  Task task;
  const Cliques some = maximum_cliques(graph, all_of(graph), 1, 7, task);
  CHECK(some.all.size() == 7);
  CHECK_FALSE(some.complete);
  const Cliques all = maximum_cliques(graph, all_of(graph), 1, 8, task);
  CHECK(all.all.size() == 8);
  CHECK(all.complete);
}

TEST_CASE("cliques__below_the_least_size_are_none_and_words_of_bits_join") {
  const PairGraph graph = grouped(70, 1);  // complete, over two words
  Task task;
  const Cliques found = maximum_cliques(graph, all_of(graph), 3, 10, task);
  REQUIRE(found.all.size() == 1);
  CHECK(found.all[0].size() == 70);
  CHECK(maximum_cliques(graph, all_of(graph), 71, 10, task).all.empty());
}

TEST_CASE("cliques__hold_candidates_only") {
  const PairGraph graph = grouped(4, 2);
  Task task;
  const Cliques found = maximum_cliques(graph, {0b00010111}, 1, 10, task);
  // Nodes 0, 1 of the first group, 2 of the second, 4 of the third.
  CHECK(found.all == std::vector<std::vector<size_t>>{{0, 2, 4}, {1, 2, 4}});
}
