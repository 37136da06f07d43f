// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/e57/pages.h"

#include <doctest/doctest.h>

#include "unit/formats/e57/packed_records.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("e57_pages__bytes_come_without_checksums_from_any_page_on") {
  std::string held;
  for (size_t i = 0; i < 600 * e57::kHeldBytes; ++i) held += static_cast<char>(i * i / 7);
  const OpenedFile file(paged(held), "a.e57");
  for (const unsigned threads : {1u, 3u}) {
    Task task(Task::Hooks{.threads = threads});
    for (const size_t first : {size_t{0}, size_t{257}, size_t{599}}) {
      std::string read(held.size() - first * e57::kHeldBytes, '\0');
      e57::read_pages(file, first, 600 - first, reinterpret_cast<std::byte*>(read.data()), task);
      CHECK(read == held.substr(first * e57::kHeldBytes));
    }
  }
}

TEST_CASE("e57_pages__a_damaged_page_is_named_by_its_offset") {
  std::string bytes = paged(std::string(20 * e57::kHeldBytes, 'a'));
  bytes[17 * e57::kPageBytes + 600] = 'b';
  bytes[19 * e57::kPageBytes + 1023] ^= 1;
  const OpenedFile file(bytes, "a.e57");
  Task task;
  std::string read(20 * e57::kHeldBytes, '\0');
  const Failure failure = failure_of(
      [&] { e57::read_pages(file, 0, 20, reinterpret_cast<std::byte*>(read.data()), task); });
  CHECK(failure.status == Status::kFormat);
  CHECK(has_text(failure.text, "offset 17408"));
  CHECK(has_text(failure.text, "checksum"));
}

TEST_CASE("e57_pages__offsets_with_and_without_checksums_lead_to_each_other") {
  for (const uint64_t held : {0u, 1u, 1019u, 1020u, 1021u, 204000u, 12345678u})
    CHECK(e57::logical_offset(e57::physical_offset(held)) == held);
  CHECK(e57::physical_offset(1019) == 1019);
  CHECK(e57::physical_offset(1020) == 1024);
}
