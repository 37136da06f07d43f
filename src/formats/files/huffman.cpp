// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/huffman.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

#include "formats/files/bit_writer.h"

namespace jalon {

namespace {

struct Node {
  size_t left = 0, right = 0;  ///< children; symbols come before all inner nodes
};

// Depth of each symbol in Huffman's tree.
std::vector<uint8_t> depths_of(const std::vector<uint64_t>& weights) {
  const size_t symbols = weights.size();
  std::vector<uint8_t> depths(symbols, 0);
  std::vector<Node> inner;
  using Entry = std::pair<uint64_t, size_t>;  // weight, node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (size_t s = 0; s < symbols; ++s)
    if (weights[s] != 0) open.emplace(weights[s], s);
  if (open.size() == 1) depths[open.top().second] = 1;  // a code has a bit at least
  while (open.size() > 1) {
    const Entry a = open.top();
    open.pop();
    const Entry b = open.top();
    open.pop();
    open.emplace(a.first + b.first, symbols + inner.size());
    inner.push_back({a.second, b.second});
  }
  std::vector<uint8_t> below(inner.size(), 0);  // depth of the inner nodes, from the root down
  for (size_t i = inner.size(); i-- > 0;)
    for (const size_t child : {inner[i].left, inner[i].right})
      (child < symbols ? depths[child] : below[child - symbols]) =
          static_cast<uint8_t>(below[i] + 1);
  return depths;
}

}  // namespace

PrefixCode prefix_code(std::span<const uint32_t> frequencies, uint32_t most) {
  std::vector<uint64_t> weights(frequencies.begin(), frequencies.end());
  PrefixCode out{depths_of(weights), std::vector<uint16_t>(weights.size(), 0)};
  while (std::ranges::max(out.lengths) > most) {
    for (uint64_t& weight : weights) weight = (weight + 1) / 2;
    out.lengths = depths_of(weights);
  }
  uint32_t next = 0;
  for (uint32_t bits = 1; bits <= most; ++bits, next <<= 1)
    for (size_t s = 0; s < weights.size(); ++s)
      if (out.lengths[s] == bits)
        out.codes[s] = static_cast<uint16_t>(BitWriter::turned(next++, bits));
  return out;
}

}  // namespace jalon
