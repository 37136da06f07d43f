// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace jalon {

struct TwinPair {
  size_t gone, come;
  double share;
};

/// Pairs of things gone and come, each in one pair at most: the largest share first, of equal ones the first gone, then
/// the first come. share_of(gone, come) is at most 1, negative where the two are no pair. What explains all of it wins
/// over all that follow, so that neither of the two is asked about again: of n things of one shape n pairs are asked
/// about, not n squared.
template <class ShareOf>
std::vector<TwinPair> twin_pairs(size_t gone, size_t come, ShareOf&& share_of) {
  std::vector<TwinPair> asked;
  std::vector<bool> is_gone_paired(gone), is_come_paired(come);
  for (size_t g = 0; g < gone; ++g)
    for (size_t c = 0; c < come; ++c) {
      if (is_come_paired[c]) continue;
      const double share = share_of(g, c);
      if (share >= 0) asked.push_back({g, c, share});
      if (!(share >= 1)) continue;
      is_come_paired[c] = true;
      break;
    }
  std::stable_sort(asked.begin(), asked.end(),
                   [](const TwinPair& a, const TwinPair& b) { return a.share > b.share; });
  is_come_paired.assign(come, false);
  std::vector<TwinPair> out;
  for (const TwinPair& pair : asked) {
    if (is_gone_paired[pair.gone] || is_come_paired[pair.come]) continue;
    is_gone_paired[pair.gone] = is_come_paired[pair.come] = true;
    out.push_back(pair);
  }
  return out;
}

}  // namespace jalon
