// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/graph.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr double kNormalSlack =
    0.35;  // of cosines: normals of cells at edges are good to some 20 degrees
constexpr size_t kGraphGrain = 16;

struct Place {
  Vec3 p, n;
};

bool is_rigid(const Place& a, const Place& b, const Place& x, const Place& y, double tolerance_m,
              double nearest_m) {
  const Vec3 ab = b.p - a.p, xy = y.p - x.p;
  const double l = norm(ab), m = norm(xy);
  if (l < nearest_m || m < nearest_m || std::abs(l - m) > tolerance_m) return false;
  if (std::abs(std::abs(dot(a.n, b.n)) - std::abs(dot(x.n, y.n))) > kNormalSlack) return false;
  return std::abs(std::abs(dot(a.n, ab)) / l - std::abs(dot(x.n, xy)) / m) <= kNormalSlack &&
         std::abs(std::abs(dot(b.n, ab)) / l - std::abs(dot(y.n, xy)) / m) <= kNormalSlack;
}

}  // namespace

MatchGraph::MatchGraph(std::span<const FeatureMatch> matches, const CoarseSurface& reference,
                       const CoarseSurface& moving, double tolerance_m, double nearest_m,
                       Task& task)
    : count_(matches.size()), words_((count_ + 63) / 64), bits_(count_ * words_), degrees_(count_) {
  std::vector<Place> from(count_), to(count_);
  for (size_t i = 0; i < count_; ++i) {
    from[i] = {moving.points[matches[i].moving], moving.normals[matches[i].moving]};
    to[i] = {reference.points[matches[i].reference], reference.normals[matches[i].reference]};
  }
  parallel_for(task, count_, kGraphGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      uint64_t* bits = bits_.data() + i * words_;
      for (size_t j = 0; j < count_; ++j)
        if (is_rigid(from[i], from[j], to[i], to[j], tolerance_m, nearest_m)) {
          bits[j / 64] |= uint64_t{1} << (j % 64);
          ++degrees_[i];
        }
    }
  });
}

size_t MatchGraph::common(const uint64_t* a, const uint64_t* b) const {
  size_t n = 0;
  for (size_t w = 0; w < words_; ++w) n += static_cast<size_t>(std::popcount(a[w] & b[w]));
  return n;
}

std::vector<uint32_t> MatchGraph::clique(size_t seed) const {
  std::vector<uint32_t> out{static_cast<uint32_t>(seed)};
  std::vector<uint64_t> left(row(seed), row(seed) + words_);
  while (true) {
    size_t best = count_, most = 0;
    for (size_t w = 0; w < words_; ++w)
      for (uint64_t rest = left[w]; rest != 0; rest &= rest - 1) {
        const size_t i = w * 64 + static_cast<size_t>(std::countr_zero(rest));
        const size_t n = common(left.data(), row(i)) + 1;
        if (n > most) most = n, best = i;
      }
    if (best == count_) return out;
    out.push_back(static_cast<uint32_t>(best));
    for (size_t w = 0; w < words_; ++w) left[w] &= row(best)[w];
  }
}

std::vector<std::vector<uint32_t>> MatchGraph::cliques(size_t most, size_t least,
                                                       Task& task) const {
  // Second-order degree (Chen et al. 2022, SC2-PCR): the neighbours that a match shares with its neighbours; wrong
  // matches have neighbours by chance, which share few.
  std::vector<uint64_t> second(count_);
  parallel_for(task, count_, kGraphGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      for (size_t w = 0; w < words_; ++w)
        for (uint64_t rest = row(i)[w]; rest != 0; rest &= rest - 1)
          second[i] += common(row(i), row(w * 64 + static_cast<size_t>(std::countr_zero(rest))));
  });
  std::vector<uint32_t> order(count_);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return second[a] > second[b]; });
  std::vector<std::vector<uint32_t>> out;
  std::vector<uint8_t> is_used(count_);
  for (const uint32_t seed : order) {
    if (out.size() == most || second[seed] == 0) break;
    if (is_used[seed]) continue;
    task.checkpoint(static_cast<double>(out.size()) / static_cast<double>(most));
    std::vector<uint32_t> members = clique(seed);
    for (const uint32_t i : members) is_used[i] = 1;
    is_used[seed] = 1;
    if (members.size() >= least) out.push_back(std::move(members));
  }
  return out;
}

}  // namespace jalon
