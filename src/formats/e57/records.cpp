// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/e57/records.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "base/parallel.h"
#include "formats/e57/pages.h"
#include "formats/files/endian.h"

namespace jalon::e57 {

namespace {

constexpr uint64_t kWindowPages = 4096;   // 4 MiB: some 65 of the largest packets
constexpr size_t kLargestPacket = 65536;  // its length less 1 has 16 bits
constexpr uint64_t kPacketPages = kLargestPacket / kHeldBytes + 2;  // cut by both ends
constexpr size_t kPadding = 16;  // behind a stream: a value is loaded as nine bytes
constexpr size_t kSectionHead = 32, kAlignment = 4;
constexpr size_t kPacketHead = 4, kDataHead = 6;  // kind, flags, length; number of streams
constexpr uint8_t kDataPacket = 1, kLastKind = 2;

/// `count` integers of so many bits each, from a bit on.
template <class Number>
void unpack(const std::byte* bytes, size_t bit, uint32_t bits, size_t count, Number&& number) {
  const uint64_t mask = bits == 64 ? ~uint64_t{0} : (uint64_t{1} << bits) - 1;
  for (size_t i = 0; i < count; ++i, bit += bits) {
    const std::byte* const at = bytes + bit / 8;
    const unsigned shift = bit % 8;
    uint64_t raw = load<uint64_t>(at) >> shift;
    if (shift + bits > 64) raw |= static_cast<uint64_t>(at[8]) << (64 - shift);
    number(i, raw & mask);
  }
}

}  // namespace

Records::Records(const ByteSource& source, uint64_t section, uint64_t count,
                 std::vector<RecordColumn> columns, Task& task)
    : source_(source),
      columns_(std::move(columns)),
      file_pages_(source.size() / kPageBytes),
      left_(count),
      streams_(columns_.size()) {
  read_head(section, task);
  // Without a bit for any of them the file would hold any number of points.
  const bool takes_bits = std::any_of(columns_.begin(), columns_.end(),
                                      [](const RecordColumn& c) { return c.packing.bits > 0; });
  if (count > 0 && !takes_bits) source.refuse(section, "no column of the points takes any bytes");
  window_ = Buffer<std::byte>((std::min(kWindowPages, file_pages_) + kPacketPages) * kHeldBytes);
  for (Stream& stream : streams_) stream.bytes.resize(kPadding);
}

void Records::read_head(uint64_t section, Task& task) {
  const uint64_t at = logical_offset(section);
  if (section >= source_.size() || at + kSectionHead > file_pages_ * kHeldBytes)
    source_.refuse(section, "the section of the points lies behind the end of the file");
  std::byte pages[2 * kHeldBytes];
  const uint64_t first = at / kHeldBytes, last = (at + kSectionHead - 1) / kHeldBytes;
  read_pages(source_, first, last - first + 1, pages, task);
  const std::byte* const head = pages + (at - first * kHeldBytes);
  if (head[0] != std::byte{1}) source_.refuse(section, "no section of points begins here");
  const auto length = load<uint64_t>(head + 8), packets = load<uint64_t>(head + 16);
  if (length % kAlignment != 0)
    source_.refuse(section + 8, "the length of the section of points is no multiple of 4");
  if (packets >= source_.size())
    source_.refuse(section + 16, "the packets of points lie behind the end of the file");
  end_ = at + std::min(length, source_.size());
  first_page_ = logical_offset(packets) / kHeldBytes;
  at_ = logical_offset(packets) % kHeldBytes;
}

size_t Records::next(Task& task) {
  forget();
  while (left_ > 0 && here_ == 0) {
    read_window(task);
    append(take_packets(), task);
  }
  left_ -= here_;
  return here_;
}

void Records::forget() {
  for (size_t c = 0; c < streams_.size(); ++c) {
    Stream& stream = streams_[c];
    const size_t bit = stream.first_bit + here_ * columns_[c].packing.bits;
    stream.bytes.erase(stream.bytes.begin(),
                       stream.bytes.begin() + static_cast<std::ptrdiff_t>(bit / 8));
    stream.first_bit = bit % 8;
  }
  here_ = 0;
}

// What is left of the window, and pages behind it: as far as the section is said to go, or where
// that was too short for one packet.
void Records::read_window(Task& task) {
  const size_t gone = std::min(at_ / kHeldBytes, pages_);
  pages_ -= gone;
  at_ -= gone * kHeldBytes;
  first_page_ += gone;
  std::memmove(window_.data(), window_.data() + gone * kHeldBytes, pages_ * kHeldBytes);
  const uint64_t next = first_page_ + pages_;
  if (next >= file_pages_)
    source_.refuse(source_.size(), "the file ends before the last %llu points of a scan",
                   static_cast<unsigned long long>(left_));
  uint64_t count = std::min(kWindowPages, file_pages_ - next);
  const uint64_t end = (end_ + kHeldBytes - 1) / kHeldBytes;
  count = std::min(count, end > next ? end - next : kPacketPages);
  read_pages(source_, next, count, window_.data() + pages_ * kHeldBytes, task);
  pages_ += count;
}

// As many as are wanted: other things than packets follow.
std::vector<Records::Packet> Records::take_packets() {
  std::vector<Packet> packets;
  std::vector<size_t> held;  // bytes of each stream
  for (const Stream& stream : streams_) held.push_back(stream.bytes.size() - kPadding);
  do here_ = whole_records(held);
  while (here_ < left_ && take_packet(packets, held));
  return packets;
}

// False where its end is not in the window. Those that index others or are to be ignored go by.
bool Records::take_packet(std::vector<Packet>& packets, std::vector<size_t>& held) {
  const size_t room = pages_ * kHeldBytes - std::min(at_, pages_ * kHeldBytes);
  if (room < kPacketHead) return false;
  const std::byte* const head = window_.data() + at_;
  const size_t length = size_t{1} + load<uint16_t>(head + 2);
  const auto kind = static_cast<uint8_t>(head[0]);
  if (kind > kLastKind) refuse("no packet of points begins here");
  if (length % kAlignment != 0) refuse("the length of the packet is no multiple of 4");
  if (room < length) return false;
  if (kind == kDataPacket) {
    size_t end = kDataHead + 2 * streams_.size();
    if (length < end || load<uint16_t>(head + kPacketHead) != streams_.size())
      refuse("the packet holds not one stream for each column");
    packets.push_back({at_ + end, at_ + kDataHead});
    for (size_t c = 0; c < streams_.size(); ++c) {
      const size_t bytes = load<uint16_t>(head + kDataHead + 2 * c);
      held[c] += bytes;
      end += bytes;
    }
    if (end > length) refuse("the streams of the packet are longer than it");
  }
  at_ += length;
  return true;
}

void Records::append(const std::vector<Packet>& packets, Task& task) {
  parallel_chunks(task, streams_.size(), [&](size_t c) {
    std::vector<std::byte>& bytes = streams_[c].bytes;
    bytes.resize(bytes.size() - kPadding);
    for (const Packet& packet : packets) {
      const std::byte* const lengths = window_.data() + packet.lengths;
      const std::byte* piece = window_.data() + packet.pieces;
      for (size_t before = 0; before < c; ++before) piece += load<uint16_t>(lengths + 2 * before);
      bytes.insert(bytes.end(), piece, piece + load<uint16_t>(lengths + 2 * c));
    }
    bytes.resize(bytes.size() + kPadding);
  });
}

size_t Records::whole_records(const std::vector<size_t>& held) const {
  uint64_t records = left_;
  for (size_t c = 0; c < streams_.size(); ++c)
    if (const uint32_t bits = columns_[c].packing.bits; bits > 0)
      records = std::min<uint64_t>(records, (8 * held[c] - streams_[c].first_bit) / bits);
  return static_cast<size_t>(records);
}

void Records::values(size_t column, size_t first, size_t count, double* out) const {
  const RecordColumn& c = columns_[column];
  const auto [least, bits] = c.packing;
  const std::byte* const bytes = streams_[column].bytes.data();
  const size_t bit = streams_[column].first_bit + first * bits;
  const auto whole = [least = static_cast<uint64_t>(least)](uint64_t raw) {
    return static_cast<double>(static_cast<int64_t>(least + raw));
  };
  const auto put = [&, bits = bits](auto number) {
    unpack(bytes, bit, bits, count, [&](size_t i, uint64_t raw) { out[i] = number(raw); });
  };
  if (c.kind == kJcDouble) put([](uint64_t raw) { return std::bit_cast<double>(raw); });
  else if (c.kind == kJcSingle)
    put([](uint64_t raw) { return std::bit_cast<float>(static_cast<uint32_t>(raw)); });
  else if (c.kind == kJcInteger) put(whole);
  else put([&](uint64_t raw) { return whole(raw) * c.scale + c.offset; });
}

// The packet that comes next.
void Records::refuse(const char* reason) const {
  source_.refuse(physical_offset(first_page_ * kHeldBytes + at_), "%s", reason);
}

}  // namespace jalon::e57
