// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/radius_batch.h"

#include <cmath>
#include <memory>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kGrain = 256;  // queries a chunk

template <class T>
std::shared_ptr<Column> column_of(const char* name, const char* unit, const char* meaning,
                                  size_t count) {
  return std::make_shared<Column>(FieldInfo{name, element_type_of<T>(), 1, unit, meaning}, count);
}

// The chunks' answers one after the other; each is given back as soon as it is copied.
FieldTable joined(std::vector<std::vector<Neighbour>>& chunks, size_t total) {
  auto index = column_of<uint64_t>("index", "", "index of the point in the cloud", total);
  auto distance = column_of<double>("distance", "m", "distance from the query", total);
  const auto indices = index->values<uint64_t>();
  const auto distances = distance->values<double>();
  size_t at = 0;
  for (auto& chunk : chunks) {
    for (const Neighbour& n : chunk) {
      indices[at] = n.index;
      distances[at++] = std::sqrt(n.squared_distance);
    }
    chunk = {};
  }
  FieldTable table;
  table.set(std::move(index));
  table.set(std::move(distance));
  return table;
}

}  // namespace

RadiusNeighbours radius_neighbours(const Octree& tree, std::span<const Vec3> queries,
                                   double radius_m, Task& task) {
  const size_t count = queries.size();
  std::vector<std::vector<Neighbour>> chunks((count + kGrain - 1) / kGrain);
  auto first =
      column_of<uint64_t>("first", "", "where the neighbours of each query begin", count + 1);
  const auto firsts = first->values<uint64_t>();
  // 1. Search: the number of each query's neighbours stands one row behind it.
  parallel_for(task, count, kGrain, [&](size_t begin, size_t end) {
    std::vector<Neighbour> found;
    auto& chunk = chunks[begin / kGrain];
    for (size_t i = begin; i < end; ++i) {
      // A ball may hold most of the cloud.
      if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
      tree.radius(queries[i], radius_m, found);
      chunk.insert(chunk.end(), found.begin(), found.end());
      firsts[i + 1] = found.size();
    }
  });
  // 2. Numbers become places; 3. the answers in one piece.
  firsts[0] = 0;
  for (size_t i = 0; i < count; ++i) firsts[i + 1] += firsts[i];
  RadiusNeighbours out;
  out.neighbours = joined(chunks, firsts[count]);
  out.ranges.set(std::move(first));
  return out;
}

}  // namespace jalon
