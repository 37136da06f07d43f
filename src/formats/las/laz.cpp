// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/laz.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "formats/codecs/codecs.h"
#include "formats/files/endian.h"

namespace jalon::las {

namespace {

constexpr const char* kLazUser = "laszip encoded";
constexpr unsigned kLazRecord = 22204;
constexpr size_t kTableHead = 8;  // of the chunk table: version and number of chunks
// Points that a byte may stand for, above one chunk of the usual size. Scanners' files have less than
// one, and up to the first number none is asked about; equal points come to some 400. The coder's most
// likely symbols cost 3.5e-4 bits, a point a few of them: beyond the second a count lies.
constexpr uint64_t kTrustedPerByte = 64, kMostPerByte = 4096, kUsualChunk = 65536;

bool may_stand_for(uint64_t bytes, uint64_t points, uint64_t points_per_byte) {
  return points <= kUsualChunk || (points - kUsualChunk) / points_per_byte <= bytes;
}

/// A line that a decoder leaves.
struct Line {
  char text[300] = {};
  JcMessage message() { return {text, sizeof text}; }
};

const uint8_t* bytes_of(const std::vector<std::byte>& bytes) {
  return reinterpret_cast<const uint8_t*>(bytes.data());
}

}  // namespace

LazPoints::LazPoints(const ByteSource& source, const Header& header,
                     const std::vector<Record>& vlrs)
    : source_(source), header_(header) {
  const Layout layout = read_layout(vlrs);
  if (header.count == 0) return;
  const uint64_t packed = source.size() - header.point_offset;
  if (layout.has_chunks) {
    read_table(layout.chunk_points);
    number_points(layout.chunk_points);
  } else {
    chunks_.push_back({header.point_offset, packed, 0, header.count});
  }
}

LazPoints::LazPoints(const ByteSource& source, const Header& header,
                     const std::vector<Record>& vlrs, std::vector<LazChunk> found)
    : source_(source), header_(header), chunks_(std::move(found)) {
  read_layout(vlrs);
  checks_counts_ = point_format(header.format)->extended;  // chunks of the others do not tell
}

LazPoints::Layout LazPoints::read_layout(const std::vector<Record>& vlrs) {
  for (const Record& record : vlrs)
    if (record.is(kLazUser, kLazRecord)) vlr_.assign(record.data(), record.data() + record.size());
  if (vlr_.empty())
    source_.refuse(104, "the points are compressed, and no record \"%s\" tells how", kLazUser);
  Line line;
  JcLazLayout layout{};
  if (has_failed(jc_laz_layout(bytes_of(vlr_), vlr_.size(), &layout, line.message())))
    source_.refuse(header_.size, "the record \"%s\": %s", kLazUser, line.text);
  if (layout.record_bytes != header_.record_bytes)
    source_.refuse(105, "point records have %u bytes, those of the compressor %llu",
                   header_.record_bytes, static_cast<unsigned long long>(layout.record_bytes));
  return {layout.chunk_points, layout.has_chunks != 0};
}

uint64_t LazPoints::find_table() const {
  // Where the writer could not go back, the place stands at the end of the file.
  std::byte place[8];
  source_.read(header_.point_offset, place, sizeof place);
  auto at = static_cast<uint64_t>(load<int64_t>(place));
  if (load<int64_t>(place) <= static_cast<int64_t>(header_.point_offset)) {
    source_.read(source_.size() - sizeof place, place, sizeof place);
    at = static_cast<uint64_t>(load<int64_t>(place));
  }
  if (at < header_.point_offset + 8 || !source_.has(at, kTableHead))
    source_.refuse(header_.point_offset, "the chunk table would lie at offset %llu",
                   static_cast<unsigned long long>(at));
  return at;
}

void LazPoints::read_table(uint64_t chunk_points) {
  const uint64_t table = find_table();
  const uint64_t room = table - header_.point_offset - 8;
  std::byte head[kTableHead];
  source_.read(table, head, sizeof head);
  const uint64_t count = load<uint32_t>(head + 4);
  if (count > room / header_.record_bytes)  // each begins with a whole point
    source_.refuse(table + 4, "the chunk table has %llu chunks, the file room for %llu",
                   static_cast<unsigned long long>(count),
                   static_cast<unsigned long long>(room / header_.record_bytes));
  // Two numbers a chunk, of at most 32 bits and what the coder adds.
  constexpr uint64_t kMostEntryBytes = 16, kMostTailBytes = 64;
  std::vector<std::byte> bytes(
      std::min(source_.size() - table, kTableHead + kMostEntryBytes * count + kMostTailBytes));
  source_.read(table, bytes.data(), bytes.size());
  std::vector<uint64_t> points(count), sizes(count);
  Line line;
  if (has_failed(jc_laz_chunks(bytes_of(bytes), bytes.size(), chunk_points == 0 ? 1 : 0,
                               points.data(), sizes.data(), count, line.message())))
    source_.refuse(table, "%s", line.text);
  uint64_t at = header_.point_offset + 8;
  for (uint64_t c = 0; c < count; ++c) {
    if (sizes[c] > table - at)
      source_.refuse(table, "chunk %llu of %llu bytes would reach into the chunk table",
                     static_cast<unsigned long long>(c + 1),
                     static_cast<unsigned long long>(sizes[c]));
    chunks_.push_back({at, sizes[c], 0, points[c]});
    at += sizes[c];
  }
}

void LazPoints::number_points(uint64_t chunk_points) {
  uint64_t first = 0;
  for (LazChunk& chunk : chunks_) {
    chunk.first = first;
    if (chunk_points != 0) chunk.points = std::min(chunk_points, header_.count - first);
    if (chunk.points > header_.count - first)
      source_.refuse(header_.point_offset, "the chunks hold more than the %llu points promised",
                     static_cast<unsigned long long>(header_.count));
    first += chunk.points;
  }
  if (first != header_.count)
    source_.refuse(header_.point_offset, "the chunks hold %llu of the %llu points promised",
                   static_cast<unsigned long long>(first),
                   static_cast<unsigned long long>(header_.count));
}

void LazPoints::require_points(Task& task) const {
  uint64_t bytes = 0;
  for (const LazChunk& chunk : chunks_) bytes += chunk.bytes;
  if (!may_stand_for(bytes, count(), kMostPerByte))
    source_.refuse(
        header_.point_offset, "%llu points are promised, more than %llu compressed bytes stand for",
        static_cast<unsigned long long>(count()), static_cast<unsigned long long>(bytes));
  if (may_stand_for(bytes, count(), kTrustedPerByte)) return;
  parallel_chunks(task, chunks_.size(), [&](size_t c) {
    Line line;
    if (has_failed(jc_laz_check(bytes_of(vlr_), vlr_.size(),
                                reinterpret_cast<const uint8_t*>(packed(c).get()), chunks_[c].bytes,
                                chunks_[c].points, line.message())))
      source_.refuse(chunks_[c].offset, "chunk %zu of the compressed points: %s", c + 1, line.text);
  });
}

std::unique_ptr<std::byte[]> LazPoints::packed(size_t number) const {
  const LazChunk& chunk = chunks_[number];
  auto packed = std::make_unique_for_overwrite<std::byte[]>(chunk.bytes);
  source_.read(chunk.offset, packed.get(), chunk.bytes);
  if (checks_counts_) {  // layered chunks: the first point, then the number of points
    const size_t count_at = header_.record_bytes;
    if (chunk.bytes < count_at + 4 || load<uint32_t>(packed.get() + count_at) != chunk.points)
      source_.refuse(chunk.offset, "the chunk is not one of the %llu points promised",
                     static_cast<unsigned long long>(chunk.points));
  }
  return packed;
}

// run(packed bytes, their number, records, their bytes, message)
template <class Decode>
std::unique_ptr<std::byte[]> LazPoints::decoded(size_t number, Decode&& run) const {
  const LazChunk& chunk = chunks_[number];
  const auto from = packed(number);
  const size_t bytes = chunk.points * header_.record_bytes;
  auto records = std::make_unique_for_overwrite<std::byte[]>(bytes);
  Line line;
  if (has_failed(run(reinterpret_cast<const uint8_t*>(from.get()), chunk.bytes,
                     reinterpret_cast<uint8_t*>(records.get()), bytes, line.message())))
    source_.refuse(chunk.offset, "chunk %zu of the compressed points: %s", number + 1, line.text);
  return records;
}

std::unique_ptr<std::byte[]> LazPoints::decode(size_t number) const {
  return decoded(number, [&](const uint8_t* from, uint64_t size, uint8_t* to, uint64_t room,
                             JcMessage message) {
    return jc_laz_decode(bytes_of(vlr_), vlr_.size(), from, size, to, room, message);
  });
}

std::unique_ptr<std::byte[]> LazPoints::decode_within(size_t number, const StepBox& box,
                                                      size_t& count) const {
  const std::array<int32_t, 6> steps = {box.least[0], box.least[1], box.least[2],
                                        box.most[0],  box.most[1],  box.most[2]};
  uint64_t wanted = 0;
  auto records = decoded(number, [&](const uint8_t* from, uint64_t size, uint8_t* to, uint64_t room,
                                     JcMessage message) {
    return jc_laz_decode_within(bytes_of(vlr_), vlr_.size(), from, size, steps.data(), to, room,
                                &wanted, message);
  });
  count = static_cast<size_t>(wanted);
  return records;
}

StepBox step_box(const Header& header, const Vec3& metres, const Box3& box_m) {
  constexpr double kLeast = std::numeric_limits<int32_t>::min(),
                   kMost = std::numeric_limits<int32_t>::max();
  constexpr double kRounding = 0x1p-40;  // of places computed in doubles
  StepBox steps;
  bool has_places = true;
  for (int k = 0; k < 3; ++k) {
    const double scale = header.scale[k], offset = header.offset[k];
    has_places = has_places && std::isfinite((kLeast * scale + offset) * metres[k]) &&
                 std::isfinite((kMost * scale + offset) * metres[k]);
    const double low = box_m.min[k] / metres[k], high = box_m.max[k] / metres[k];
    const double a = (low - offset) / scale, b = (high - offset) / scale;
    const auto slack = [&](double place) {
      return 1 + kRounding * (std::fabs(place) + std::fabs(offset)) / std::fabs(scale);
    };
    const double least = std::min(a - slack(low), b - slack(high));
    const double most = std::max(a + slack(low), b + slack(high));
    // Neither is a number where the box has no end.
    const auto at = static_cast<size_t>(k);
    steps.least[at] =
        static_cast<int32_t>(least > kLeast ? std::min(std::floor(least), kMost) : kLeast);
    steps.most[at] = static_cast<int32_t>(most < kMost ? std::max(std::ceil(most), kLeast) : kMost);
  }
  if (!has_places) steps = {{INT32_MIN, INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX, INT32_MAX}};
  return steps;
}

}  // namespace jalon::las
