// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/deflate_blocks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "formats/files/bit_writer.h"
#include "formats/files/huffman.h"

namespace jalon {

namespace {

// RFC 1951: 256 bytes, the end of the block, 29 lengths; order of the lengths of code lengths (3.2.7).
constexpr size_t kSymbols = 286, kEnd = 256, kLengthCodes = 19;
constexpr uint32_t kMostBits = 15, kMostBitsOfLengths = 7;
constexpr size_t kBlockBytes = size_t{1} << 17;
constexpr size_t kLeastRun = 4, kMostRun = 258;
constexpr std::array<uint8_t, kLengthCodes> kOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                      11, 4,  12, 3, 13, 2, 14, 1, 15};

/// A byte, or the length of a repetition of the byte before.
struct Item {
  uint16_t symbol = 0, extra = 0;
  uint8_t extra_bits = 0;
};

Item run_of(size_t length) {
  if (length == kMostRun) return {285, 0, 0};
  // Lengths 3 ... 10 have a code each; then four codes share each number of extra bits.
  const size_t off = length - 3;
  if (off < 8) return {static_cast<uint16_t>(257 + off), 0, 0};
  uint8_t bits = 1;
  while (off >> (bits + 3) != 0) ++bits;
  const size_t group = off >> bits;  // 4 ... 7
  return {static_cast<uint16_t>(257 + 4 * bits + group),
          static_cast<uint16_t>(off - (group << bits)), bits};
}

std::vector<Item> items_of(std::string_view bytes) {
  std::vector<Item> items;
  items.reserve(bytes.size() + 1);
  for (size_t at = 0; at < bytes.size();) {
    size_t run = 0;
    if (at > 0)
      while (run < kMostRun && at + run < bytes.size() && bytes[at + run] == bytes[at - 1]) ++run;
    if (run >= kLeastRun) {
      items.push_back(run_of(run));
      at += run;
    } else {
      items.push_back({static_cast<unsigned char>(bytes[at++]), 0, 0});
    }
  }
  items.push_back({kEnd, 0, 0});
  return items;
}

// The lengths of the code's bits: themselves Huffman's, runs of zeros told as such.
void put_code(BitWriter& writer, const PrefixCode& code) {
  std::vector<uint8_t> lengths = code.lengths;
  lengths.push_back(1);  // the one distance, of a byte
  std::vector<Item> items;
  for (size_t at = 0; at < lengths.size();) {
    size_t zeros = 0;
    while (zeros < 138 && at + zeros < lengths.size() && lengths[at + zeros] == 0) ++zeros;
    if (zeros >= 11) items.push_back({18, static_cast<uint16_t>(zeros - 11), 7});
    else if (zeros >= 3) items.push_back({17, static_cast<uint16_t>(zeros - 3), 3});
    else items.push_back({lengths[at], 0, 0});
    at += zeros >= 3 ? zeros : 1;
  }
  std::array<uint32_t, kLengthCodes> frequencies{};
  for (const Item& item : items) ++frequencies[item.symbol];
  const PrefixCode of_lengths = prefix_code(frequencies, kMostBitsOfLengths);
  writer.bits(static_cast<uint32_t>(code.lengths.size() - 257), 5);
  writer.bits(0, 5);  // one distance
  writer.bits(kLengthCodes - 4, 4);
  for (const uint8_t symbol : kOrder) writer.bits(of_lengths.lengths[symbol], 3);
  for (const Item& item : items) {
    writer.bits(of_lengths.codes[item.symbol], of_lengths.lengths[item.symbol]);
    writer.bits(item.extra, item.extra_bits);
  }
}

// A block and, behind it, an empty one that ends with a whole byte: blocks can be laid side by side.
std::string block_of(std::string_view bytes) {
  const std::vector<Item> items = items_of(bytes);
  std::array<uint32_t, kSymbols> frequencies{};
  for (const Item& item : items) ++frequencies[item.symbol];
  const PrefixCode code = prefix_code(frequencies, kMostBits);
  BitWriter writer;
  writer.bits(0, 1);  // not the last
  writer.bits(2, 2);  // with codes of its own
  put_code(writer, code);
  for (const Item& item : items) {
    writer.bits(code.codes[item.symbol], code.lengths[item.symbol]);
    if (item.symbol <= kEnd) continue;
    writer.bits(item.extra, item.extra_bits);
    writer.bits(0, 1);  // the distance
  }
  writer.bits(0, 3);  // not the last, stored
  writer.flush();
  writer.out() += std::string("\0\0\xff\xff", 4);
  return std::move(writer.out());
}

}  // namespace

std::string zlib_blocks(std::string_view bytes, Task& task) {
  const size_t count = (bytes.size() + kBlockBytes - 1) / kBlockBytes;
  std::vector<std::string> blocks(count);
  parallel_chunks(task, count, [&](size_t b) {
    blocks[b] = block_of(bytes.substr(b * kBlockBytes, kBlockBytes));
  });
  std::string out = "\x78\x01";
  for (const std::string& block : blocks) out += block;
  out += std::string("\1\0\0\xff\xff", 5);  // the last block: empty, stored
  put_adler32(out, adler32(bytes));
  return out;
}

}  // namespace jalon
