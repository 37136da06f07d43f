// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/select.h"

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "base/parallel.h"
#include "cloud/operations.h"

namespace jalon {

namespace {

constexpr size_t kSelectGrain = 1 << 16;

/// Rows of these indices; constant sizes become plain moves.
template <class Size>
void gather_rows(const std::byte* from, std::byte* to, Size size, std::span<const uint64_t> indices,
                 Task& task) {
  parallel_for(task, indices.size(), kSelectGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) std::memcpy(to + i * size, from + indices[i] * size, size);
  });
}

void gather_bytes(const void* source, void* target, size_t size, std::span<const uint64_t> indices,
                  Task& task) {
  const auto* from = static_cast<const std::byte*>(source);
  auto* to = static_cast<std::byte*>(target);
  switch (size) {
    case 1:
      return gather_rows(from, to, std::integral_constant<size_t, 1>{}, indices, task);
    case 2:
      return gather_rows(from, to, std::integral_constant<size_t, 2>{}, indices, task);
    case 4:
      return gather_rows(from, to, std::integral_constant<size_t, 4>{}, indices, task);
    case 8:
      return gather_rows(from, to, std::integral_constant<size_t, 8>{}, indices, task);
    case 12:
      return gather_rows(from, to, std::integral_constant<size_t, 12>{}, indices, task);
    case 24:
      return gather_rows(from, to, std::integral_constant<size_t, 24>{}, indices, task);
    default:
      return gather_rows(from, to, size, indices, task);
  }
}

void require_in_range(const Cloud& cloud, std::span<const uint64_t> indices) {
  for (size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= cloud.size())
      fail(Status::kInvalidArgument, "index %llu at position %llu; the cloud has %llu points",
           static_cast<unsigned long long>(indices[i]), static_cast<unsigned long long>(i),
           static_cast<unsigned long long>(cloud.size()));
}

/// Each station whose points stay together, in the order of the new points. A station torn apart
/// by the order is left out.
std::vector<Station> surviving_stations(const Cloud& cloud, std::span<const uint64_t> indices,
                                        Task& task) {
  if (cloud.stations.empty()) return {};
  std::vector<Station> runs;
  std::vector<size_t> sources;  // station of each run
  std::vector<uint32_t> run_counts(cloud.stations.size(), 0);
  const Station* current = nullptr;
  for (size_t i = 0; i < indices.size(); ++i) {
    if (i % kSelectGrain == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(indices.size()));
    const bool same = current != nullptr && indices[i] - current->first < current->count;
    if (!same) {
      current = station_of(cloud, indices[i]);
      if (current != nullptr) {
        const auto source = static_cast<size_t>(current - cloud.stations.data());
        // Only the first run matters; more of them just disqualify the station.
        if (run_counts[source]++ == 0) {
          runs.push_back(*current);
          runs.back().first = i;
          runs.back().count = 0;
          sources.push_back(source);
        }
      }
    }
    if (current != nullptr &&
        sources[runs.size() - 1] == static_cast<size_t>(current - cloud.stations.data()))
      ++runs.back().count;
  }
  std::vector<Station> kept;
  for (size_t i = 0; i < runs.size(); ++i)
    if (run_counts[sources[i]] == 1) kept.push_back(runs[i]);
  return kept;
}

}  // namespace

Cloud select_unchecked(const Cloud& cloud, std::span<const uint64_t> indices, Task& task) {
  const double steps = static_cast<double>(cloud.fields.size()) + 3;
  double step = 0;
  const auto next = [&](double width) {
    const double from = step;
    step += width / steps;
    return std::pair{from, std::min(step, 1.0)};
  };
  Cloud out;
  {
    const auto [from, to] = next(2);
    ProgressSpan span(task, from, to);
    Buffer<double> xyz(3 * indices.size());
    gather_bytes(cloud.xyz_buffer->data(), xyz.data(), 3 * sizeof(double), indices, task);
    out = make_cloud(std::move(xyz));
  }
  for (const ColumnPtr& column : cloud.fields) {
    const auto [from, to] = next(1);
    ProgressSpan span(task, from, to);
    const FieldInfo& info = column->info();
    auto chosen = std::make_shared<Column>(info, indices.size());
    gather_bytes(column->raw(), chosen->raw(), size_of(info.type) * info.components, indices, task);
    out.fields.set(std::move(chosen));
  }
  const auto [from, to] = next(1);
  ProgressSpan span(task, from, to);
  out.stations = surviving_stations(cloud, indices, task);
  out.crs = cloud.crs;
  out.attachments = cloud.attachments;
  return out;
}

Cloud select(const Cloud& cloud, std::span<const uint64_t> indices, Task& task) {
  require_in_range(cloud, indices);
  return select_unchecked(cloud, indices, task);
}

Cloud select_kept(const Cloud& cloud, std::span<const uint64_t> ascending, Task& task) {
  if (ascending.size() == cloud.size())
    return cloud;  // nothing goes: share the points and their index
  return select_unchecked(cloud, ascending, task);
}

std::vector<uint64_t> indices_of(std::span<const uint8_t> mask, uint8_t value, Task& task) {
  const size_t chunks = (mask.size() + kSelectGrain - 1) / kSelectGrain;
  std::vector<uint64_t> starts(chunks + 1, 0);
  parallel_for(task, mask.size(), kSelectGrain, [&](size_t begin, size_t end) {
    uint64_t n = 0;
    for (size_t i = begin; i < end; ++i) n += mask[i] == value;
    starts[begin / kSelectGrain + 1] = n;
  });
  for (size_t c = 0; c < chunks; ++c) starts[c + 1] += starts[c];
  std::vector<uint64_t> indices(starts[chunks]);
  parallel_for(task, mask.size(), kSelectGrain, [&](size_t begin, size_t end) {
    uint64_t at = starts[begin / kSelectGrain];
    for (size_t i = begin; i < end; ++i)
      if (mask[i] == value) indices[at++] = i;
  });
  return indices;
}

Cloud select_mask(const Cloud& cloud, std::span<const uint8_t> mask, uint8_t value, Task& task) {
  if (mask.size() != cloud.size())
    fail(Status::kInternal, "a mask of %zu bytes for %zu points", mask.size(), cloud.size());
  std::vector<uint64_t> indices;
  {
    ProgressSpan span(task, 0, 0.2);
    indices = indices_of(mask, value, task);
  }
  ProgressSpan span(task, 0.2, 1);
  return select_kept(cloud, indices, task);
}

}  // namespace jalon
