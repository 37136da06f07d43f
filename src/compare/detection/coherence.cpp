// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/coherence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "base/parallel.h"
#include "spatial/union_find.h"

namespace jalon {

namespace {

constexpr uint32_t kBeside = 8;    // cores next to one, itself besides
constexpr size_t kLeastAlike = 2;  // of them
constexpr double kOneTest = 1.96;  // standard deviations: 95 % of a single test
constexpr size_t kCoherenceGrain = 512;

class Neighbourhoods {
 public:
  Neighbourhoods(const SurfaceCores& reference, const SurfaceCores& compared,
                 const CoreTests& tests)
      : reference_(reference), compared_(compared), tests_(tests) {}

  // Next to a core, as far as its own points and theirs meet.
  template <class F>
  void for_each(size_t core, F&& f) const {
    std::array<Neighbour, kBeside + 1> found;
    const size_t n = compared_.nearest(compared_[core].centroid, kBeside + 1, found);
    for (size_t k = 0; k < n; ++k) {
      const size_t other = found[k].index;
      const double reach = compared_[core].radius_m + compared_[other].radius_m;
      if (other != core && found[k].squared_distance <= reach * reach) f(other);
    }
  }
  bool is_alike(size_t a, size_t b) const {
    const CoreTest &p = tests_.cores[a], &q = tests_.cores[b];
    if (p.state != q.state) return false;
    return p.state != CoreState::kMoved || same_side(p, q);
  }
  bool same_side(const CoreTest& p, const CoreTest& q) const {
    return p.distance_m * q.distance_m *
               dot(reference_[p.surface].normal, reference_[q.surface].normal) >
           0;
  }
  bool exceeds_own_level(size_t core) const {
    const CoreTest& test = tests_.cores[core];
    return test.has_surface && test.state == CoreState::kUnchanged &&
           std::abs(test.distance_m) > kOneTest * tests_.null_scale * test.sigma_m;
  }

 private:
  const SurfaceCores &reference_, &compared_;
  const CoreTests& tests_;
};

// Step 1.
void take_back_lonely(const Neighbourhoods& around, CoreTests& tests, Task& task) {
  std::vector<uint8_t> lonely(tests.cores.size(), 0);
  parallel_for(task, lonely.size(), kCoherenceGrain, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      const CoreState state = tests.cores[k].state;
      if (state != CoreState::kMoved && state != CoreState::kNew) continue;
      size_t alike = 0;
      around.for_each(k, [&](size_t other) { alike += around.is_alike(k, other) ? 1 : 0; });
      lonely[k] = alike < kLeastAlike ? 1 : 0;
    }
  });
  for (size_t k = 0; k < lonely.size(); ++k)
    if (lonely[k] != 0)
      tests.cores[k].state =
          tests.cores[k].state == CoreState::kMoved ? CoreState::kUnchanged : CoreState::kUntold;
}

// Step 2.
void grow_moved(const Neighbourhoods& around, CoreTests& tests, Task& task) {
  std::vector<uint32_t> front;
  for (size_t k = 0; k < tests.cores.size(); ++k)
    if (tests.cores[k].state == CoreState::kMoved) front.push_back(static_cast<uint32_t>(k));
  for (size_t done = 0; done < front.size(); ++done) {
    if (done % kCoherenceGrain == 0)
      task.checkpoint(static_cast<double>(done) / static_cast<double>(front.size()));
    const size_t k = front[done];
    around.for_each(k, [&](size_t other) {
      if (!around.exceeds_own_level(other) || !around.same_side(tests.cores[k], tests.cores[other]))
        return;
      tests.cores[other].state = CoreState::kMoved;
      front.push_back(static_cast<uint32_t>(other));
    });
  }
}

// Step 3.
void take_back_of_few_surfaces(const Neighbourhoods& around, CoreTests& tests, Task& task) {
  UnionFind pieces(tests.cores.size());
  for (size_t k = 0; k < tests.cores.size(); ++k) {
    if (tests.cores[k].state != CoreState::kMoved) continue;
    if (k % kCoherenceGrain == 0)
      task.checkpoint(static_cast<double>(k) / static_cast<double>(tests.cores.size()));
    around.for_each(k, [&](size_t other) {
      if (around.is_alike(k, other))
        pieces.join(static_cast<uint32_t>(k), static_cast<uint32_t>(other));
    });
  }
  std::map<uint32_t, std::set<uint32_t>> surfaces;  // by piece
  for (uint32_t k = 0; k < tests.cores.size(); ++k)
    if (tests.cores[k].state == CoreState::kMoved)
      surfaces[pieces.find(k)].insert(tests.cores[k].surface);
  for (uint32_t k = 0; k < tests.cores.size(); ++k)
    if (tests.cores[k].state == CoreState::kMoved && surfaces[pieces.find(k)].size() <= kLeastAlike)
      tests.cores[k].state = CoreState::kUnchanged;
}

}  // namespace

void settle_together(const SurfaceCores& reference, const SurfaceCores& compared, CoreTests& tests,
                     Task& task) {
  const Neighbourhoods around(reference, compared, tests);
  take_back_lonely(around, tests, task);
  grow_moved(around, tests, task);
  take_back_of_few_surfaces(around, tests, task);
}

}  // namespace jalon
