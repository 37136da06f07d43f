// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/task.h"

namespace jalon {

/// Undirected graph as rows of bits.
class PairGraph {
 public:
  explicit PairGraph(size_t nodes)
      : nodes_(nodes), words_((nodes + 63) / 64), bits_(nodes * words_) {}
  size_t nodes() const { return nodes_; }
  size_t words() const { return words_; }
  const uint64_t* row(size_t i) const { return bits_.data() + i * words_; }
  void join(size_t i, size_t j) {
    bits_[i * words_ + j / 64] |= uint64_t{1} << (j % 64);
    bits_[j * words_ + i / 64] |= uint64_t{1} << (i % 64);
  }

 private:
  size_t nodes_, words_;
  std::vector<uint64_t> bits_;
};

struct Cliques {
  std::vector<std::vector<size_t>>
      all;               ///< maximum ones, each ascending, in the order of their nodes
  bool complete = true;  ///< false: there are more than were asked for, or the search was too long
};

/// All cliques of the largest size, of `least` nodes and more, at most so many: branch and bound by greedy colouring
/// (Tomita & Seki 2003). candidates: the nodes to search among.
Cliques maximum_cliques(const PairGraph& graph, const std::vector<uint64_t>& candidates,
                        size_t least, size_t most, Task& task);

}  // namespace jalon
