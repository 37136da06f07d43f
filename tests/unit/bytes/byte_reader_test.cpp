// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/byte_reader.h"

#include <doctest/doctest.h>

#include "bytes/byte_writer.h"

namespace jalon {
namespace {

/// What write() wrote, read by read(), which must use all of it; the message of a refusal, or "".
template <class Write, class Read>
std::string read_back(Write&& write, Read&& read) {
  Task task;
  ByteWriter writer;
  write(writer);
  const Buffer<uint8_t> whole = writer.sealed(BytesKind::kFields, task);
  ByteReader reader({whole.data(), whole.size()}, BytesKind::kFields, task);
  try {
    read(reader);
    reader.end();
  } catch (const Error& error) {
    CHECK(error.status() == Status::kFormat);
    return error.what();
  }
  return "";
}

TEST_CASE("byte_reader__gives_back_what_was_written") {
  Part part;
  part.name = "fen\xC3\xAAtre 2.3";
  part.copied_from = 5;
  part.evidence = Evidence::kCopied;
  const std::vector<Part> parts{part, Part()};
  const std::vector<Vec3> points{{1, 2, 3}, {-0.0, 5e-324, 1e300}};
  CHECK(read_back(
            [&](ByteWriter& w) {
              w.list(parts);
              w.list(points);
              w.item(true);
            },
            [&](ByteReader& r) {
              std::vector<Part> a;
              std::vector<Vec3> b;
              r.list(a);
              r.list(b);
              REQUIRE(a.size() == 2);
              CHECK(a[0].name == part.name);
              CHECK(a[0].copied_from == 5);
              CHECK(a[0].evidence == Evidence::kCopied);
              CHECK(a[1].parent == kNoParent);
              CHECK(b == points);
              CHECK(r.take<bool>());
            }) == "");
}

TEST_CASE("byte_reader__believes_no_count") {
  for (const uint64_t told : {uint64_t{3}, uint64_t{1} << 61, ~uint64_t{0}}) {
    const auto write = [&](ByteWriter& w) {
      w.item(told);
      w.item(uint64_t{0});
    };
    std::vector<double> numbers;
    std::vector<Part> parts;
    CHECK(read_back(write, [&](ByteReader& r) { r.list(numbers); }) != "");
    CHECK(read_back(write, [&](ByteReader& r) { r.list(parts); }) != "");
    CHECK(numbers.empty());
    CHECK(parts.empty());
  }
  CHECK(read_back([](ByteWriter& w) { w.item(uint64_t{9}); }, [](ByteReader& r) { r.text(); }) ==
        "the bytes of a table of fields are wrong at byte 40: 9 items of 1 bytes are told where 0 "
        "bytes "
        "are left");
}

TEST_CASE("byte_reader__refuses_texts_that_are_none_and_what_is_left") {
  for (const std::string_view bad : {std::string_view("a\xff"), std::string_view("a\0b", 3)})
    CHECK(read_back([&](ByteWriter& w) { w.text(bad); }, [](ByteReader& r) { r.text(); })
              .find("not valid UTF-8") != std::string::npos);
  CHECK(read_back([](ByteWriter& w) { w.item(uint8_t{2}); }, [](ByteReader& r) { r.take<bool>(); })
            .find("2 is neither 0 nor 1") != std::string::npos);
  CHECK(read_back([](ByteWriter& w) { w.item(uint32_t{2}); },
                  [](ByteReader& r) { r.take<uint8_t>(); })
            .find("3 bytes stand behind the end") != std::string::npos);
}

}  // namespace
}  // namespace jalon
