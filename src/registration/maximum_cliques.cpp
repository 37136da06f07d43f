// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/maximum_cliques.h"

#include <algorithm>
#include <bit>

namespace jalon {

namespace {

constexpr uint64_t kMostSteps = 5'000'000;  // of the search: some seconds
constexpr uint64_t kStepsPerCheck = 1024;

using Bits = std::vector<uint64_t>;

template <class F>
void for_each_bit(const Bits& bits, F&& f) {
  for (size_t w = 0; w < bits.size(); ++w)
    for (uint64_t left = bits[w]; left != 0; left &= left - 1)
      f(w * 64 + static_cast<size_t>(std::countr_zero(left)));
}

class Search {
 public:
  Search(const PairGraph& graph, size_t least, size_t most, Task& task)
      : graph_(graph), best_(least), most_(most), task_(task) {}

  Cliques run(const Bits& candidates) {
    expand(candidates);
    std::sort(out_.all.begin(), out_.all.end());
    return std::move(out_);
  }

 private:
  // Nodes in the order of their colours: colour c bounds the clique that a node and those before it can hold.
  void colour(const Bits& candidates, std::vector<size_t>& order,
              std::vector<size_t>& colours) const {
    Bits left = candidates;
    for (size_t c = 1; std::any_of(left.begin(), left.end(), [](uint64_t w) { return w != 0; });
         ++c) {
      Bits free = left;
      for (size_t w = 0; w < free.size(); ++w)
        while (free[w] != 0) {
          const size_t node = w * 64 + static_cast<size_t>(std::countr_zero(free[w]));
          const uint64_t* row = graph_.row(node);
          left[w] &= ~(uint64_t{1} << (node % 64));
          free[w] &= ~(uint64_t{1} << (node % 64));
          for (size_t v = w; v < free.size(); ++v) free[v] &= ~row[v];
          order.push_back(node);
          colours.push_back(c);
        }
    }
  }

  void record() {
    if (clique_.size() < best_) return;
    if (clique_.size() > best_) out_ = {};
    best_ = clique_.size();
    if (out_.all.size() >= most_) {
      out_.complete = false;
      return;
    }
    out_.all.push_back(clique_);
    std::sort(out_.all.back().begin(), out_.all.back().end());
  }

  void expand(Bits candidates) {
    if (++steps_ % kStepsPerCheck == 0) task_.checkpoint(0);
    if (steps_ > kMostSteps) {
      out_.complete = false;
      return;
    }
    std::vector<size_t> order, colours;
    colour(candidates, order, colours);
    if (order.empty()) return record();
    for (size_t i = order.size(); i-- > 0;) {
      if (clique_.size() + colours[i] < best_) return;
      const size_t node = order[i];
      Bits next = candidates;
      for (size_t w = 0; w < next.size(); ++w) next[w] &= graph_.row(node)[w];
      clique_.push_back(node);
      expand(std::move(next));
      clique_.pop_back();
      candidates[node / 64] &= ~(uint64_t{1} << (node % 64));
    }
  }

  const PairGraph& graph_;
  size_t best_, most_;
  Task& task_;
  uint64_t steps_ = 0;
  std::vector<size_t> clique_;
  Cliques out_;
};

}  // namespace

Cliques maximum_cliques(const PairGraph& graph, const std::vector<uint64_t>& candidates,
                        size_t least, size_t most, Task& task) {
  return Search(graph, least, most, task).run(candidates);
}

}  // namespace jalon
