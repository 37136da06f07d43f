// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include "formats/files/endian.h"
#include "formats/las/copc.h"

namespace jalon::las {

namespace {

constexpr size_t kBlockEntries = 2048;  // read at once: 64 KiB

unsigned long long whole(uint64_t number) { return number; }

class Hierarchy {
 public:
  Hierarchy(const ByteSource& source, const Header& header, const CopcInfo& info,
            const CopcPart& part)
      : source_(source), header_(header), info_(info), part_(part) {
    // Points lie on steps of the file, which a writer may have rounded after it chose their node.
    constexpr double kRounding = 0x1p-40;  // of coordinates computed in doubles
    for (int k = 0; k < 3; ++k)
      slack_[k] =
          std::fabs(header.scale[k]) + kRounding * (std::fabs(info.centre[k]) + info.halfsize);
  }

  std::vector<LazChunk> chunks(Task& task) {
    add_page(info_.page_offset, info_.page_bytes, kPagePlace);
    while (!pages_.empty()) {
      const Page page = pages_.back();
      pages_.pop_back();
      read_page(page, task);
    }
    std::ranges::sort(chunks_, {}, &LazChunk::offset);
    uint64_t points = 0;
    for (size_t i = 0; i < chunks_.size(); ++i) {
      LazChunk& chunk = chunks_[i];
      if (i != 0 && chunks_[i - 1].offset + chunks_[i - 1].bytes > chunk.offset)
        source_.refuse(chunk.offset, "two nodes of the octree share these points");
      chunk.first = points;
      points += chunk.points;
    }
    if (points > header_.count)
      source_.refuse(info_.page_offset,
                     "the nodes of the hierarchy have %llu points: more than the file, which has "
                     "%llu",
                     whole(points), whole(header_.count));
    return std::move(chunks_);
  }

 private:
  static constexpr uint64_t kPagePlace = 375 + kVlrHeader + 40;  // that the record tells of
  struct Page {
    uint64_t offset, bytes;
  };

  // said_at: where the file tells of it.
  void add_page(uint64_t offset, uint64_t bytes, uint64_t said_at) {
    if (bytes == 0 || bytes % kCopcEntryBytes != 0 || !source_.has(offset, bytes))
      source_.refuse(said_at, "a page of the hierarchy would lie at offset %llu with %llu bytes",
                     whole(offset), whole(bytes));
    page_bytes_ += bytes;
    if (!seen_.insert(offset).second || page_bytes_ > source_.size())
      source_.refuse(said_at, "the page of the hierarchy at offset %llu is told twice",
                     whole(offset));
    pages_.push_back({offset, bytes});
  }

  void read_page(const Page& page, Task& task) {
    std::vector<std::byte> block;
    for (uint64_t done = 0; done < page.bytes; done += block.size()) {
      task.checkpoint(0);
      block.resize(std::min<uint64_t>(page.bytes - done, kBlockEntries * kCopcEntryBytes));
      source_.read(page.offset + done, block.data(), block.size());
      for (size_t at = 0; at < block.size(); at += kCopcEntryBytes)
        add_entry(block.data() + at, page.offset + done + at);
    }
  }

  void add_entry(const std::byte* bytes, uint64_t at) {
    const CopcEntry entry = {{load<int32_t>(bytes), load<int32_t>(bytes + 4),
                              load<int32_t>(bytes + 8), load<int32_t>(bytes + 12)},
                             load<uint64_t>(bytes + 16),
                             load<int32_t>(bytes + 24),
                             load<int32_t>(bytes + 28)};
    const CopcKey& key = entry.key;
    const int64_t cells = int64_t{1} << std::clamp(key.level, 0, kMostCopcLevel);
    const auto is_cell = [&](int32_t number) { return number >= 0 && number < cells; };
    if (key.level < 0 || key.level > kMostCopcLevel || !is_cell(key.x) || !is_cell(key.y) ||
        !is_cell(key.z))
      source_.refuse(at, "there is no node %d-%d-%d-%d", key.level, key.x, key.y, key.z);
    if (entry.points < -1 || entry.bytes < 0)
      source_.refuse(at + 24, "node %d-%d-%d-%d has %d points in %d bytes", key.level, key.x, key.y,
                     key.z, entry.points, entry.bytes);
    if (entry.points == 0 || !is_wanted(key)) return;
    if (entry.points == -1) add_page(entry.offset, static_cast<uint64_t>(entry.bytes), at + 16);
    else add_node(entry, at);
  }

  void add_node(const CopcEntry& entry, uint64_t at) {
    const auto bytes = static_cast<uint64_t>(entry.bytes);
    const auto points = static_cast<uint64_t>(entry.points);
    // A chunk begins with a whole point.
    if (entry.offset < header_.point_offset || bytes < header_.record_bytes ||
        !source_.has(entry.offset, bytes))
      source_.refuse(at + 16, "the points of a node would lie at offset %llu with %llu bytes",
                     whole(entry.offset), whole(bytes));
    chunks_.push_back({entry.offset, bytes, 0, points});
  }

  // The page of a node holds the tree below it, which lies inside its cell.
  bool is_wanted(const CopcKey& key) const {
    if (key.level > part_.most_level) return false;
    const double edge = std::ldexp(2 * info_.halfsize, -key.level);
    const int32_t cell[3] = {key.x, key.y, key.z};
    for (int k = 0; k < 3; ++k) {
      const double low = info_.centre[k] - info_.halfsize + cell[k] * edge;
      if (low - slack_[k] > part_.box.max[k] || low + edge + slack_[k] < part_.box.min[k])
        return false;
    }
    return true;
  }

  const ByteSource& source_;
  const Header& header_;
  const CopcInfo& info_;
  const CopcPart& part_;
  Vec3 slack_;
  std::vector<Page> pages_;
  std::set<uint64_t> seen_;
  uint64_t page_bytes_ = 0;
  std::vector<LazChunk> chunks_;
};

}  // namespace

std::vector<LazChunk> copc_chunks(const ByteSource& source, const Header& header,
                                  const CopcInfo& info, const CopcPart& part, Task& task) {
  return Hierarchy(source, header, info, part).chunks(task);
}

}  // namespace jalon::las
