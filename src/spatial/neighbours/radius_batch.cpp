// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/radius_batch.h"

#include <atomic>
#include <cmath>
#include <memory>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "spatial/neighbours/ball_ranges.h"

namespace jalon {

namespace {

constexpr size_t kGrain = 256;  // queries a chunk
// Neighbours that a chunk keeps until it is known where they go. Balls with more hold much of the cloud; they are
// counted first and searched again then, so that their lists exist once.
constexpr size_t kMostKept = size_t{1} << 18;

template <class T>
std::shared_ptr<Column> column_of(const char* name, const char* unit, const char* meaning,
                                  size_t count) {
  return std::make_shared<Column>(FieldInfo{name, element_type_of<T>(), 1, unit, meaning}, count);
}

// The queries of a chunk, from the first on.
struct Chunk {
  std::vector<Neighbour> kept;
  size_t searched = 0;  // queries whose neighbours are kept
};

void check_cancel(const Task& task) {
  // A ball may hold most of the cloud.
  if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
}

}  // namespace

RadiusNeighbours radius_neighbours(const Octree& tree, std::span<const Vec3> queries,
                                   double radius_m, Task& task, size_t most_kept) {
  const size_t count = queries.size();
  std::vector<Chunk> chunks((count + kGrain - 1) / kGrain);
  std::atomic<size_t> all_kept{0};  // what is kept or found anew is the same
  auto first =
      column_of<uint64_t>("first", "", "where the neighbours of each query begin", count + 1);
  const auto firsts = first->values<uint64_t>();
  // 1. Search: the number of each query's neighbours stands one row behind it.
  {
    const ProgressSpan span(task, 0, 0.8);
    parallel_for(task, count, kGrain, [&](size_t begin, size_t end) {
      std::vector<Neighbour> found;
      BallRanges ranges(tree.impl(), radius_m);
      Chunk& chunk = chunks[begin / kGrain];
      for (size_t i = begin; i < end; ++i) {
        check_cancel(task);
        if (chunk.kept.size() > kMostKept || all_kept > most_kept) {
          ranges.find(queries[i]);
          firsts[i + 1] = ranges.points();
          continue;
        }
        tree.radius(queries[i], radius_m, found);
        chunk.kept.insert(chunk.kept.end(), found.begin(), found.end());
        all_kept += found.size();
        ++chunk.searched;
        firsts[i + 1] = found.size();
      }
    });
  }
  // 2. Numbers become places.
  firsts[0] = 0;
  for (size_t i = 0; i < count; ++i) firsts[i + 1] += firsts[i];
  auto index = column_of<uint64_t>("index", "", "index of the point in the cloud", firsts[count]);
  auto distance = column_of<double>("distance", "m", "distance from the query", firsts[count]);
  const auto indices = index->values<uint64_t>();
  const auto distances = distance->values<double>();
  // 3. The answers in one piece.
  const ProgressSpan span(task, 0.8, 1);
  parallel_for(task, count, kGrain, [&](size_t begin, size_t end) {
    Chunk& chunk = chunks[begin / kGrain];
    uint64_t at = firsts[begin];
    const auto write = [&](const std::vector<Neighbour>& neighbours) {
      for (const Neighbour& n : neighbours) {
        indices[at] = n.index;
        distances[at++] = std::sqrt(n.squared_distance);
      }
    };
    write(chunk.kept);
    chunk.kept = {};
    std::vector<Neighbour> found;
    for (size_t i = begin + chunk.searched; i < end; ++i) {
      check_cancel(task);
      tree.radius(queries[i], radius_m, found);
      write(found);
    }
  });
  RadiusNeighbours out;
  out.ranges.set(std::move(first));
  out.neighbours.set(std::move(index));
  out.neighbours.set(std::move(distance));
  return out;
}

}  // namespace jalon
