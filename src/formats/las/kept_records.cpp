// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/kept_records.h"

#include <algorithm>
#include <cstring>

#include "base/parallel.h"

namespace jalon::las {

namespace {

// The least that allocators surely give back to the system at once: glibc's largest threshold.
constexpr size_t kSlabBytes = size_t{32} << 20;

// Moves them to the front, in order; their number.
size_t moved_to_front(std::byte* records, size_t count, size_t record_bytes,
                      const std::function<bool(const std::byte*)>& is_kept) {
  std::byte* to = records;
  for (const std::byte* from = records; count-- > 0; from += record_bytes) {
    if (!is_kept(from)) continue;
    if (to != from) std::memcpy(to, from, record_bytes);
    to += record_bytes;
  }
  return static_cast<size_t>(to - records) / record_bytes;
}

}  // namespace

KeptRecords::KeptRecords(const LazPoints& laz, size_t record_bytes, const StepBox& steps,
                         const std::function<bool(const std::byte*)>& is_kept, Task& task)
    : record_bytes_(record_bytes),
      slab_bytes_(std::min<uint64_t>(kSlabBytes, laz.count() * record_bytes)),
      parts_(laz.chunks()) {
  parallel_chunks(task, laz.chunks(), [&](size_t c) {
    if (laz.points(c) == 0) return;
    size_t count = 0;
    const auto records = laz.decode_within(c, steps, count);
    const size_t kept = moved_to_front(records.get(), count, record_bytes_, is_kept);
    if (kept != 0) parts_[c] = stored(records.get(), kept);
  });
  for (Part& part : parts_) {
    part.first = count_;
    count_ += part.count;
  }
}

KeptRecords::Part KeptRecords::stored(const std::byte* records, size_t count) {
  const size_t bytes = count * record_bytes_;
  Part part;
  part.count = count;
  std::byte* to = nullptr;
  {
    const std::lock_guard lock(filling_);
    if (slabs_.empty() || slabs_.back().size() - filled_ < bytes) {
      slabs_.emplace_back(std::max(slab_bytes_, bytes));
      filled_ = 0;
    }
    part.slab = slabs_.size() - 1;
    part.at = filled_;
    filled_ += bytes;
    to = slabs_.back().data() + part.at;
  }
  std::memcpy(to, records, bytes);
  return part;
}

void KeptRecords::give(const std::function<void(const std::byte*, size_t, size_t)>& put,
                       Task& task) {
  std::vector<std::vector<Part>> of_slabs(slabs_.size());
  for (const Part& part : parts_)
    if (part.count != 0) of_slabs[part.slab].push_back(part);
  const auto slabs = static_cast<double>(slabs_.size());
  for (size_t s = 0; s < slabs_.size(); ++s) {
    ProgressSpan span(task, static_cast<double>(s) / slabs, static_cast<double>(s + 1) / slabs);
    parallel_chunks(task, of_slabs[s].size(), [&](size_t p) {
      const Part& part = of_slabs[s][p];
      put(slabs_[s].data() + part.at, part.count, part.first);
    });
    slabs_[s] = {};
  }
}

}  // namespace jalon::las
