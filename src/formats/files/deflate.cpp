// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/deflate.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "formats/files/bit_writer.h"

namespace jalon {

namespace {

constexpr size_t kShortest = 3, kLongest = 258;  // repetitions, RFC 1951, 3.2.5
constexpr size_t kFarthest = 32768;
constexpr uint32_t kEndOfBlock = 256;

struct Code {
  uint16_t base;
  uint8_t extra_bits;
};
constexpr std::array<Code, 29> kLengths = {
    {{3, 0},  {4, 0},  {5, 0},  {6, 0},   {7, 0},   {8, 0},   {9, 0},   {10, 0},  {11, 1}, {13, 1},
     {15, 1}, {17, 1}, {19, 2}, {23, 2},  {27, 2},  {31, 2},  {35, 3},  {43, 3},  {51, 3}, {59, 3},
     {67, 4}, {83, 4}, {99, 4}, {115, 4}, {131, 5}, {163, 5}, {195, 5}, {227, 5}, {258, 0}}};
constexpr std::array<Code, 30> kDistances = {
    {{1, 0},     {2, 0},     {3, 0},     {4, 0},      {5, 1},      {7, 1},
     {9, 2},     {13, 2},    {17, 3},    {25, 3},     {33, 4},     {49, 4},
     {65, 5},    {97, 5},    {129, 6},   {193, 6},    {257, 7},    {385, 7},
     {513, 8},   {769, 8},   {1025, 9},  {1537, 9},   {2049, 10},  {3073, 10},
     {4097, 11}, {6145, 11}, {8193, 12}, {12289, 12}, {16385, 13}, {24577, 13}}};

void symbol(BitWriter& writer, uint32_t s) {
  if (s < 144) writer.code(0x30 + s, 8);
  else if (s < 256) writer.code(0x190 + s - 144, 9);
  else if (s < 280) writer.code(s - 256, 7);
  else writer.code(0xc0 + s - 280, 8);
}

template <size_t N>
uint32_t code_of(const std::array<Code, N>& codes, size_t value) {
  const auto after = std::upper_bound(codes.begin(), codes.end(), value,
                                      [](size_t v, const Code& c) { return v < c.base; });
  return static_cast<uint32_t>(after - codes.begin()) - 1;
}

void repetition(BitWriter& writer, size_t length, size_t distance) {
  const uint32_t l = code_of(kLengths, length), d = code_of(kDistances, distance);
  symbol(writer, 257 + l);
  writer.bits(static_cast<uint32_t>(length - kLengths[l].base), kLengths[l].extra_bits);
  writer.code(d, 5);
  writer.bits(static_cast<uint32_t>(distance - kDistances[d].base), kDistances[d].extra_bits);
}

size_t match(std::string_view bytes, size_t at, size_t distance) {
  if (distance == 0 || distance > at) return 0;
  size_t length = 0;
  const size_t longest = std::min(kLongest, bytes.size() - at);
  while (length < longest && bytes[at + length] == bytes[at + length - distance]) ++length;
  return length;
}

}  // namespace

std::string zlib_of(std::string_view bytes, size_t row_bytes) {
  if (row_bytes > kFarthest) row_bytes = 0;
  BitWriter writer;
  writer.out() = "\x78\x01";  // window of 32 KiB, fastest
  writer.bits(1, 1);          // the last block
  writer.bits(1, 2);          // fixed code
  for (size_t at = 0; at < bytes.size();) {
    const size_t run = match(bytes, at, 1), above = match(bytes, at, row_bytes);
    const size_t length = std::max(run, above);
    if (length >= kShortest) {
      repetition(writer, length, run >= above ? 1 : row_bytes);
      at += length;
    } else {
      symbol(writer, static_cast<unsigned char>(bytes[at++]));
    }
  }
  symbol(writer, kEndOfBlock);
  writer.flush();
  put_adler32(writer.out(), adler32(bytes));
  return std::move(writer.out());
}

}  // namespace jalon
