// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/laz_writer.h"

#include <algorithm>
#include <memory>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/codecs/codecs.h"
#include "formats/files/endian.h"

namespace jalon::las {

namespace {

constexpr size_t kUsualChunkPoints = 50000;           // that of LASzip
constexpr size_t kMostChunkBytes = size_t{16} << 20;  // of records: a long one has fewer points
constexpr size_t kChunksAtOnce = 16;                  // encoded in parallel, then written in order

/// What the encoder gave, freed with it.
class Packed {
 public:
  Packed() = default;
  ~Packed() { jc_bytes_free(bytes_); }
  Packed(const Packed&) = delete;
  Packed& operator=(const Packed&) = delete;
  JcBytes* out() { return &bytes_; }
  const uint8_t* data() const { return bytes_.data; }
  size_t size() const { return bytes_.count; }

 private:
  JcBytes bytes_{nullptr, 0, 0};
};

const uint8_t* as_bytes(const std::byte* bytes) { return reinterpret_cast<const uint8_t*>(bytes); }

/// Calls the encoder; what it refuses is no fault of the cloud's.
template <class F>
void encode(const std::string& path, F&& call) {
  char line[300] = {};
  if (has_failed(call(JcMessage{line, sizeof line})))
    fail(Status::kInternal, "%s: the points cannot be compressed: %s", path.c_str(), line);
}

}  // namespace

LazWriter::LazWriter(const Plan& plan, const std::string& path, Chunks chunks)
    : plan_(plan), path_(path) {
  if (chunks == Chunks::kEqual)
    chunk_points_ = std::clamp<size_t>(kMostChunkBytes / plan.record_bytes, 1, kUsualChunkPoints);
  const size_t extra = plan.record_bytes - point_format(plan.format)->bytes;
  Packed packed;
  encode(path, [&](JcMessage message) {
    return jc_laz_record(static_cast<uint8_t>(plan.format), static_cast<uint16_t>(extra),
                         static_cast<uint32_t>(chunk_points_), packed.out(), message);
  });
  const auto* data = reinterpret_cast<const std::byte*>(packed.data());
  vlr_.assign(data, data + packed.size());
}

Record LazWriter::record() const {
  return make_record("laszip encoded", 22204, "compressed points", vlr_.data(), vlr_.size());
}

LazOrder LazWriter::order_of(size_t n) const {
  LazOrder order;
  for (size_t start = 0; start < n; start += chunk_points_) order.starts.push_back(start);
  order.starts.push_back(n);
  return order;
}

LazWritten LazWriter::write(const Cloud& cloud, const LazOrder& order, AtomicFile& file,
                            uint64_t point_offset, Task& task) const {
  const size_t chunks = order.starts.size() - 1;
  const std::byte place[kLazPlaceBytes] = {};
  file.write(place, sizeof place);
  LazWritten written;
  written.bytes = sizeof place;
  written.sizes.resize(chunks);
  for (size_t first = 0; first < chunks; first += kChunksAtOnce) {
    const size_t count = std::min(kChunksAtOnce, chunks - first);
    const auto share = [&](size_t c) {
      return static_cast<double>(c) / static_cast<double>(chunks);
    };
    ProgressSpan span(task, share(first), share(first + count));
    std::vector<Packed> packed(count);
    std::vector<Tally> tallies(count);
    parallel_chunks(task, count, [&](size_t c) {
      const size_t begin = order.starts[first + c], points = order.starts[first + c + 1] - begin;
      const size_t size = points * plan_.record_bytes;
      const auto records = std::make_unique_for_overwrite<std::byte[]>(size);
      tallies[c] = order.points.empty() ? put_points(plan_, cloud, records.get(), begin, points)
                                        : put_points(plan_, cloud, records.get(),
                                                     order.points.subspan(begin, points));
      encode(path_, [&](JcMessage message) {
        return jc_laz_encode(as_bytes(vlr_.data()), vlr_.size(), as_bytes(records.get()), size,
                             packed[c].out(), message);
      });
    });
    for (size_t c = 0; c < count; ++c) {
      file.write(packed[c].data(), packed[c].size());
      written.bytes += written.sizes[first + c] = packed[c].size();
      written.tally += tallies[c];
    }
  }
  std::vector<uint64_t> counts;
  if (chunk_points_ == 0)
    for (size_t c = 0; c < chunks; ++c) counts.push_back(order.starts[c + 1] - order.starts[c]);
  put_table(file, point_offset, counts, written);
  return written;
}

void LazWriter::put_table(AtomicFile& file, uint64_t point_offset,
                          const std::vector<uint64_t>& counts, LazWritten& written) const {
  Packed table;
  encode(path_, [&](JcMessage message) {
    return jc_laz_table(as_bytes(vlr_.data()), vlr_.size(),
                        counts.empty() ? nullptr : counts.data(), written.sizes.data(),
                        written.sizes.size(), table.out(), message);
  });
  std::byte place[kLazPlaceBytes] = {};
  store<int64_t>(place, static_cast<int64_t>(point_offset + written.bytes));
  file.write(table.data(), table.size());
  written.bytes += table.size();
  file.rewrite(point_offset, place, sizeof place);
}

LazStream::LazStream(const LazWriter& writer, AtomicFile& file, uint64_t point_offset)
    : writer_(writer), file_(file), point_offset_(point_offset) {
  const std::byte place[kLazPlaceBytes] = {};
  file_.write(place, sizeof place);
  written_.bytes = sizeof place;
}

void LazStream::put(std::span<const std::byte> records, Task& task) {
  const size_t chunk = writer_.chunk_points_ * writer_.plan_.record_bytes;
  if (rest_.empty() && records.size() >= chunk) {
    const size_t whole = records.size() / chunk * chunk;
    pack(records.first(whole), chunk, task);
    records = records.subspan(whole);
  }
  rest_.insert(rest_.end(), records.begin(), records.end());
  const size_t whole = rest_.size() / chunk * chunk;
  pack(std::span(rest_).first(whole), chunk, task);
  rest_.erase(rest_.begin(), rest_.begin() + static_cast<ptrdiff_t>(whole));
}

LazWritten LazStream::finish(Task& task) {
  if (!rest_.empty()) pack(rest_, rest_.size(), task);
  writer_.put_table(file_, point_offset_, {}, written_);
  return written_;
}

void LazStream::pack(std::span<const std::byte> records, size_t chunk_bytes, Task& task) {
  const size_t chunks = records.size() / chunk_bytes;
  std::vector<Packed> packed(chunks);
  parallel_chunks(task, chunks, [&](size_t c) {
    encode(writer_.path_, [&](JcMessage message) {
      return jc_laz_encode(as_bytes(writer_.vlr_.data()), writer_.vlr_.size(),
                           as_bytes(records.data() + c * chunk_bytes), chunk_bytes, packed[c].out(),
                           message);
    });
  });
  for (const Packed& one : packed) {
    file_.write(one.data(), one.size());
    written_.bytes += one.size();
    written_.sizes.push_back(one.size());
  }
}

}  // namespace jalon::las
