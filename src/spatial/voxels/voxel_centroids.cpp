// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Centroids of cells without lists of their points:
//   1. a key for each point (voxel_numbers.h);
//   2. keys and coordinates go to buckets of their highest bits, in parallel; a bucket that holds too much of the cloud
//      is split again by its next differing bits (far outliers make most of the highest bits useless);
//   3. each bucket, now in the cache, is sorted by key; its centroids replace its records;
//   4. the centroids move together.
// All moves are stable, so the sums are those of voxel_grid(), bit for bit.

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "base/parallel.h"
#include "spatial/partition.h"
#include "spatial/radix_sort.h"
#include "spatial/voxels/voxel_grid.h"
#include "spatial/voxels/voxel_numbers.h"

namespace jalon {

namespace {

constexpr size_t kVoxelCentroidsGrain = size_t{1} << 15;
constexpr int kDigitBits = 10;  // 1024 open write streams
constexpr size_t kMostSerial = size_t{1}
                               << 19;  // points of a bucket: a cancel has to wait for its sort

/// A point with its cell; coordinates relative to the origin.
struct alignas(32) Record {
  uint64_t key;
  double x, y, z;
};
static_assert(sizeof(Record) >=
              3 * sizeof(double));  // step 3 writes a centroid in place of a record

struct Bucket {
  size_t first, count;
  bool in_second;  // which of the two record arrays holds it
};

struct KeyBits {
  uint64_t bits = 0;
  KeyBits& operator+=(const KeyBits& b) {
    bits |= b.bits;
    return *this;
  }
};

void append_buckets(const std::vector<size_t>& begins, size_t offset, bool in_second,
                    std::vector<Bucket>& buckets) {
  for (size_t b = 0; b + 1 < begins.size(); ++b)
    if (begins[b + 1] > begins[b])
      buckets.push_back({offset + begins[b], begins[b + 1] - begins[b], in_second});
}

class Centroids {
 public:
  Centroids(std::span<const double> xyz, const Vec3& origin)
      : xyz_(xyz), origin_(origin), count_(xyz.size() / 3) {}

  Buffer<double> find(const VoxelNumbers& numbers, Task& task) {
    {
      ProgressSpan span(task, 0, 0.55, "voxel grid");
      fill_buckets(numbers, task);
    }
    {
      ProgressSpan span(task, 0.55, 0.65);
      split_large(task);
    }
    {
      ProgressSpan span(task, 0.65, 0.95);
      reduce_buckets(task);
    }
    ProgressSpan span(task, 0.95, 1);
    return moved_together(task);
  }

 private:
  // Steps 1 and 2.
  void fill_buckets(const VoxelNumbers& numbers, Task& task) {
    Buffer<uint64_t> keys(count_);  // made once for both passes of the partition
    {
      ProgressSpan span(task, 0, 0.4);
      parallel_for(task, count_, kVoxelCentroidsGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) keys[i] = numbers.key(i);
      });
    }
    ProgressSpan span(task, 0.4, 1);
    const int key_bits = numbers.key_bits();
    const int digit_bits =
        std::min({kDigitBits, key_bits, static_cast<int>(std::bit_width(count_ >> 10))});
    const int shift = digit_bits == 0 ? 0 : key_bits - digit_bits;
    const uint64_t mask = (uint64_t{1} << digit_bits) - 1;
    records_[0] = Buffer<Record>(count_);
    const double* xyz = xyz_.data();
    const Vec3 o = origin_;
    append_buckets(
        partition(
            count_, size_t{1} << digit_bits, [=](const Record& r) { return r.key >> shift & mask; },
            task, records_[0].data(),
            [xyz, o, from = keys.data()](size_t i) {
              const double* p = xyz + 3 * i;
              return Record{from[i], p[0] - o.x, p[1] - o.y, p[2] - o.z};
            }),
        0, false, buckets_);
  }

  void split_large(Task& task) {
    const size_t limit = std::clamp(count_ / 16, 4 * kVoxelCentroidsGrain, kMostSerial);
    for (bool again = true; again;) {
      again = false;
      std::vector<Bucket> split;
      for (const Bucket& bucket : buckets_) {
        const int bits = bucket.count > limit ? differing_bits(bucket, task) : 0;
        if (bits == 0) {
          split.push_back(bucket);
          continue;
        }
        Buffer<Record>& to = records_[!bucket.in_second];
        if (to.empty()) to = Buffer<Record>(count_);
        const Record* from = records_[bucket.in_second].data() + bucket.first;
        const int digit_bits = std::min(kDigitBits, bits), shift = bits - digit_bits;
        const uint64_t mask = (uint64_t{1} << digit_bits) - 1;
        append_buckets(partition(
                           bucket.count, size_t{1} << digit_bits,
                           [=](const Record& r) { return r.key >> shift & mask; }, task,
                           to.data() + bucket.first, [from](size_t i) { return from[i]; }),
                       bucket.first, !bucket.in_second, split);
        again = true;
      }
      buckets_.swap(split);
    }
  }

  // How many low bits of the keys differ in the bucket.
  int differing_bits(const Bucket& bucket, Task& task) const {
    const Record* from = records_[bucket.in_second].data() + bucket.first;
    const KeyBits all = parallel_reduce(task, bucket.count, kVoxelCentroidsGrain, KeyBits{},
                                        [&](size_t begin, size_t end) {
                                          KeyBits part;
                                          for (size_t i = begin; i < end; ++i)
                                            part.bits |= from[i].key ^ from[0].key;
                                          return part;
                                        });
    return static_cast<int>(std::bit_width(all.bits));
  }

  // Step 3, in groups of buckets worth a hand-over.
  void reduce_buckets(Task& task) {
    const auto groups = groups_of(buckets_.size(), kVoxelCentroidsGrain / 2,
                                  [&](size_t b) { return buckets_[b].count; });
    cells_.assign(buckets_.size(), 0);
    parallel_chunks(task, groups.size() - 1, [&](size_t g) {
      size_t most = 0;
      for (size_t b = groups[g]; b < groups[g + 1]; ++b) most = std::max(most, buckets_[b].count);
      Buffer<uint64_t> keys(2 * most);
      Buffer<uint32_t> values(2 * most);
      Buffer<double> centroids(3 * most);
      for (size_t b = groups[g]; b < groups[g + 1]; ++b) {
        const size_t n = buckets_[b].count;
        Record* records = records_[buckets_[b].in_second].data() + buckets_[b].first;
        for (size_t i = 0; i < n; ++i) {
          keys[i] = records[i].key;
          values[i] = static_cast<uint32_t>(i);
        }
        sort_pairs({keys.data(), values.data()}, {keys.data() + most, values.data() + most}, n);
        cells_[b] = add_up(records, keys.data(), values.data(), n, centroids.data());
        std::memcpy(static_cast<void*>(records), centroids.data(), 3 * sizeof(double) * cells_[b]);
      }
    });
  }

  size_t add_up(const Record* records, const uint64_t* keys, const uint32_t* order, size_t n,
                double* out) const {
    size_t cells = 0;
    for (size_t begin = 0, end; begin < n; begin = end, ++cells) {
      Vec3 sum;
      for (end = begin; end < n && keys[end] == keys[begin]; ++end) {
        const Record& r = records[order[end]];
        sum += Vec3{r.x, r.y, r.z};
      }
      const Vec3 mean = origin_ + sum / static_cast<double>(end - begin);
      for (int axis = 0; axis < 3; ++axis) out[3 * cells + static_cast<size_t>(axis)] = mean[axis];
    }
    return cells;
  }

  // Step 4.
  Buffer<double> moved_together(Task& task) {
    std::vector<size_t> first(buckets_.size() + 1, 0);
    for (size_t b = 0; b < buckets_.size(); ++b) first[b + 1] = first[b] + cells_[b];
    Buffer<double> out(3 * first.back());
    const auto groups =
        groups_of(buckets_.size(), kVoxelCentroidsGrain, [&](size_t b) { return cells_[b]; });
    parallel_chunks(task, groups.size() - 1, [&](size_t g) {
      for (size_t b = groups[g]; b < groups[g + 1]; ++b)
        std::memcpy(out.data() + 3 * first[b],
                    records_[buckets_[b].in_second].data() + buckets_[b].first,
                    3 * sizeof(double) * cells_[b]);
    });
    return out;
  }

  std::span<const double> xyz_;
  Vec3 origin_;
  size_t count_;
  Buffer<Record> records_[2];
  std::vector<Bucket> buckets_;
  std::vector<size_t> cells_;  // of each bucket
};

}  // namespace

Buffer<double> voxel_centroids(std::span<const double> xyz, const Box3& box, const Vec3& origin,
                               double cell_m, Task& task) {
  require_voxels(xyz.size() / 3, cell_m);
  if (xyz.empty()) return {};
  const VoxelNumbers numbers(xyz, box, origin, cell_m, task);
  return Centroids(xyz, origin).find(numbers, task);
}

}  // namespace jalon
