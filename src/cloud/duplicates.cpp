// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>
#include <compare>

#include "base/buffer.h"
#include "base/error.h"
#include "base/memory_budget.h"
#include "base/parallel.h"
#include "base/text_number.h"
#include "cloud/operations.h"
#include "cloud/select.h"
#include "cloud/statistics.h"

namespace jalon {

namespace {

constexpr size_t kDuplicatesGrain = 1 << 15;
/// Points are dealt into this many buckets by hash, so that one bucket's table (8 M points: 8000
/// entries of 8 B, half full) stays in the fast cache.
constexpr size_t kBuckets = 1024;
/// Rounded coordinates beyond this do not fit 64-bit integers safely.
constexpr double kMaxSteps = 0x1p62;
constexpr uint64_t kMaxPoints = 0xfffffffeull;

struct Rounded {
  int64_t x, y, z;
  bool operator==(const Rounded&) const = default;
};

/// Coordinates in steps of the tolerance, from a corner of whole metres: the tenth of a millimetre
/// then means the same wherever the cloud lies.
struct Rounding {
  Vec3 origin;
  double tolerance_m;
  Rounded operator()(const Vec3& p) const {
    const auto steps = [&](double coordinate, double from) {
      return static_cast<int64_t>(std::floor((coordinate - from) / tolerance_m + 0.5));
    };
    return {steps(p.x, origin.x), steps(p.y, origin.y), steps(p.z, origin.z)};
  }
};

uint64_t hash_of(const Rounded& r) {
  uint64_t h = 0;
  for (const int64_t value : {r.x, r.y, r.z}) {  // splitmix64's finaliser on each word in turn
    h = (h ^ static_cast<uint64_t>(value)) + 0x9E3779B97F4A7C15ull;
    h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9ull;
    h = (h ^ (h >> 27)) * 0x94D049BB133111EBull;
    h ^= h >> 31;
  }
  return h;
}

/// A point in its bucket: part of its hash, and its index.
struct Entry {
  uint32_t hash, index;
};
/// Entry numbers of each bucket's points, ascending by point.
struct Buckets {
  Buffer<Entry> entries;
  std::vector<size_t> first;  // kBuckets + 1
};

size_t bucket_of(uint64_t hash) { return hash >> (64 - std::bit_width(kBuckets - 1)); }

/// Counting sort by bucket with fixed chunks: stable, so the order does not depend on the threads.
Buckets deal(const Cloud& cloud, const Rounding& rounding, Task& task) {
  const size_t n = cloud.size(), chunks = (n + kDuplicatesGrain - 1) / kDuplicatesGrain;
  std::vector<uint32_t> counts(chunks * kBuckets, 0);
  Buffer<uint64_t> hashes(n);
  {
    ProgressSpan span(task, 0, 0.6);
    parallel_for(task, n, kDuplicatesGrain, [&](size_t begin, size_t end) {
      uint32_t* own = counts.data() + begin / kDuplicatesGrain * kBuckets;
      for (size_t i = begin; i < end; ++i) {
        hashes[i] = hash_of(rounding(cloud.point(i)));
        ++own[bucket_of(hashes[i])];
      }
    });
  }
  Buckets buckets{Buffer<Entry>(n), std::vector<size_t>(kBuckets + 1, 0)};
  size_t at = 0;
  for (size_t b = 0; b < kBuckets; ++b) {
    buckets.first[b] = at;
    for (size_t c = 0; c < chunks; ++c) {
      const uint32_t own = counts[c * kBuckets + b];
      counts[c * kBuckets + b] = static_cast<uint32_t>(at);  // n < 2^32
      at += own;
    }
  }
  buckets.first[kBuckets] = at;
  ProgressSpan span(task, 0.6, 1);
  parallel_for(task, n, kDuplicatesGrain, [&](size_t begin, size_t end) {
    uint32_t* next = counts.data() + begin / kDuplicatesGrain * kBuckets;
    for (size_t i = begin; i < end; ++i)
      buckets.entries[next[bucket_of(hashes[i])]++] = {static_cast<uint32_t>(hashes[i]),
                                                       static_cast<uint32_t>(i)};
  });
  return buckets;
}

/// Open addressing in order of the points, so that the first of equal ones stays.
void mark_first_ones(const Cloud& cloud, const Rounding& rounding, std::span<const Entry> entries,
                     std::vector<Entry>& table, std::vector<uint8_t>& keep) {
  constexpr uint32_t kFree = 0xffffffffu;
  const size_t slots = std::bit_ceil(2 * entries.size() + 1);
  table.assign(slots, {0, kFree});
  for (const Entry& entry : entries) {
    size_t slot = entry.hash & (slots - 1);
    bool is_new = true;
    while (table[slot].index != kFree) {
      if (table[slot].hash == entry.hash &&
          rounding(cloud.point(table[slot].index)) == rounding(cloud.point(entry.index))) {
        is_new = false;
        break;
      }
      slot = (slot + 1) & (slots - 1);
    }
    if (is_new) table[slot] = entry;
    keep[entry.index] = is_new ? 1 : 0;
  }
}

void require_tolerance(const Cloud& cloud, double tolerance_m, Task& task) {
  if (!(tolerance_m > 0) || !std::isfinite(tolerance_m))
    fail(Status::kInvalidArgument, "a tolerance of %s m: it must be above 0",
         text_of(tolerance_m).c_str());
  if (cloud.size() > kMaxPoints) fail(Status::kLimit, "more than 2^32 - 2 points");
  if (cloud.size() == 0) return;
  const Box3 box = bounds(cloud, task);
  for (int i = 0; i < 3; ++i)
    if (!((box.max[i] - box.min[i] + 1) / tolerance_m < kMaxSteps))
      fail(Status::kLimit, "a tolerance of %s m is too fine for a cloud of this size",
           text_of(tolerance_m).c_str());
}

}  // namespace

Cloud without_duplicates(const Cloud& cloud, double tolerance_m, Task& task) {
  require_tolerance(cloud, tolerance_m, task);
  require_memory(cloud.size() * (sizeof(uint64_t) + sizeof(Entry)));  // deal()
  const Rounding rounding{local_origin(cloud, task), tolerance_m};
  Buckets buckets;
  {
    ProgressSpan span(task, 0, 0.4, "duplicates");
    buckets = deal(cloud, rounding, task);
  }
  std::vector<uint8_t> keep(cloud.size(), 0);
  {
    ProgressSpan span(task, 0.4, 0.7, "duplicates");
    constexpr size_t kBucketsPerChunk = 4;
    parallel_for(task, kBuckets, kBucketsPerChunk, [&](size_t begin, size_t end) {
      std::vector<Entry> table;
      for (size_t b = begin; b < end; ++b)
        mark_first_ones(
            cloud, rounding,
            {buckets.entries.data() + buckets.first[b], buckets.first[b + 1] - buckets.first[b]},
            table, keep);
    });
  }
  ProgressSpan span(task, 0.7, 1, "copying");
  return select_mask(cloud, keep, 1, task);
}

}  // namespace jalon
