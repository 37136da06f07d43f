// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/byte_writer.h"

#include <doctest/doctest.h>

#include <cstring>
#include <numeric>

namespace jalon {
namespace {

std::string payload_written(const ByteWriter& writer) {
  Task task;
  const Buffer<uint8_t> whole = writer.sealed(BytesKind::kFields, task);
  return {reinterpret_cast<const char*>(whole.data()) + kHeaderBytes, whole.size() - kHeaderBytes};
}

TEST_CASE("byte_writer__writes_little_endian_values_in_their_order") {
  ByteWriter writer;
  writer.item(uint16_t{0x0102});
  writer.item(true);
  writer.item(BytesKind::kModel);
  writer.item(std::string("ab"));
  writer.item(std::array<int8_t, 2>{-1, 1});
  CHECK(payload_written(writer) ==
        std::string("\x02\x01\x01\x03\0\0\0\x02\0\0\0\0\0\0\0ab\xff\x01", 19));
}

TEST_CASE("byte_writer__puts_large_blocks_where_they_were_written") {
  std::vector<uint8_t> large(3'000'000);
  std::iota(large.begin(), large.end(), uint8_t{0});
  ByteWriter writer;
  writer.item(uint8_t{7});
  writer.block(large.data(), large.size());
  writer.item(uint8_t{8});
  writer.block(large.data(), 3);
  writer.block(large.data(), 0);
  const std::string payload = payload_written(writer);
  REQUIRE(payload.size() == large.size() + 5);
  CHECK(payload.front() == 7);
  CHECK(std::memcmp(payload.data() + 1, large.data(), large.size()) == 0);
  CHECK(payload.substr(1 + large.size()) == std::string("\x08\0\x01\x02", 4));
}

TEST_CASE("byte_writer__writes_lists_with_their_count") {
  ByteWriter writer;
  writer.list(std::vector<uint16_t>{3, 4});
  writer.list(std::vector<std::string>{"x"});
  CHECK(payload_written(writer) ==
        std::string("\x02\0\0\0\0\0\0\0\x03\0\x04\0\x01\0\0\0\0\0\0\0\x01\0\0\0\0\0\0\0x", 29));
}

}  // namespace
}  // namespace jalon
