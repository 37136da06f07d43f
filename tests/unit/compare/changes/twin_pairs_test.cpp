// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/twin_pairs.h"

#include <doctest/doctest.h>

#include "base/random.h"

using namespace jalon;

namespace {

// All pairs, the best first.
std::vector<TwinPair> by_all_pairs(const std::vector<std::vector<double>>& shares) {
  std::vector<TwinPair> all, out;
  for (size_t g = 0; g < shares.size(); ++g)
    for (size_t c = 0; c < shares[g].size(); ++c)
      if (shares[g][c] >= 0) all.push_back({g, c, shares[g][c]});
  std::stable_sort(all.begin(), all.end(),
                   [](const TwinPair& a, const TwinPair& b) { return a.share > b.share; });
  for (const TwinPair& pair : all)
    if (std::none_of(out.begin(), out.end(),
                     [&](const TwinPair& b) { return b.gone == pair.gone || b.come == pair.come; }))
      out.push_back(pair);
  return out;
}

}  // namespace

TEST_CASE("twin_pairs__are_those_of_all_pairs_the_best_first") {
  RandomStream random(8, 0);
  for (int round = 0; round < 300; ++round) {
    const size_t gone = random.below(9), come = random.below(9);
    std::vector<std::vector<double>> shares(gone, std::vector<double>(come));
    for (auto& row : shares)
      for (double& share : row)
        share = random.below(3) == 0
                    ? -1
                    : std::min(1.0, 0.1 * static_cast<double>(5 + random.below(9)));
    const auto found = twin_pairs(gone, come, [&](size_t g, size_t c) { return shares[g][c]; });
    const auto truth = by_all_pairs(shares);
    REQUIRE(found.size() == truth.size());
    for (size_t i = 0; i < found.size(); ++i) {
      CHECK(found[i].gone == truth[i].gone);
      CHECK(found[i].come == truth[i].come);
      CHECK(found[i].share == truth[i].share);
    }
  }
}

TEST_CASE("twin_pairs__of_things_of_one_shape_ask_once_for_each") {
  constexpr size_t kThings = 100;
  size_t asked = 0;
  const auto found = twin_pairs(kThings, kThings, [&](size_t, size_t) {
    ++asked;
    return 1.0;
  });
  CHECK(found.size() == kThings);
  CHECK(asked == kThings);
}
