// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/kept_records.h"

#include <atomic>

#include "formats/las/fields.h"
#include "unit/formats/las/copc_files.h"

using namespace jalon;
using namespace jalon::las;
using namespace jalon::test;

namespace {

/// A file of several chunks, opened.
struct Chunks {
  OpenedFile file{copc_bytes(wall_and_ground(60000, 21)), "a.copc.laz"};
  Task task;
  Header header = read_header(file);
  std::vector<Record> vlrs = read_vlrs(file, header, task);
  LazPoints laz{file, header, vlrs,
                copc_chunks(file, header, copc_info(file, vlrs).value(), everywhere(), task)};

  static CopcPart everywhere() {
    CopcPart part;
    part.box = {{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}};
    return part;
  }
};

constexpr StepBox kAllSteps = {{INT32_MIN, INT32_MIN, INT32_MIN},
                               {INT32_MAX, INT32_MAX, INT32_MAX}};

bool is_low(const std::byte* record) { return load<int32_t>(record + 8) % 3 == 0; }

}  // namespace

TEST_CASE("kept_records__are_those_asked_for_in_the_order_of_the_file_whatever_the_threads") {
  if (lacks_codecs()) return;
  const Chunks chunks;
  const size_t stride = chunks.header.record_bytes;
  REQUIRE(chunks.laz.chunks() > 3);
  std::vector<std::byte> expected;
  for (size_t c = 0; c < chunks.laz.chunks(); ++c) {
    const auto records = chunks.laz.decode(c);
    for (size_t i = 0; i < chunks.laz.points(c); ++i) {
      const std::byte* record = records.get() + i * stride;
      if (is_low(record)) expected.insert(expected.end(), record, record + stride);
    }
  }
  for (const unsigned threads : {1u, 3u}) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    KeptRecords kept(chunks.laz, stride, kAllSteps, is_low, task);
    REQUIRE(kept.count() * stride == expected.size());
    std::vector<std::byte> given(expected.size());
    std::atomic<size_t> points = 0;
    kept.give(
        [&](const std::byte* records, size_t n, size_t first) {
          std::memcpy(given.data() + first * stride, records, n * stride);
          points += n;
        },
        task);
    CHECK(points == kept.count());
    CHECK(given == expected);
  }
}

TEST_CASE("kept_records__of_no_point_gives_nothing") {
  if (lacks_codecs()) return;
  Chunks chunks;
  KeptRecords kept(
      chunks.laz, chunks.header.record_bytes, kAllSteps, [](const std::byte*) { return false; },
      chunks.task);
  CHECK(kept.count() == 0);
  bool has_given = false;
  kept.give([&](const std::byte*, size_t, size_t) { has_given = true; }, chunks.task);
  CHECK_FALSE(has_given);
}

TEST_CASE("kept_records__within_steps_are_those_of_all_that_lie_there") {
  if (lacks_codecs()) return;
  Chunks chunks;
  const size_t stride = chunks.header.record_bytes;
  StepBox steps = kAllSteps;
  const auto first = chunks.laz.decode(0);
  steps.least[0] = load<int32_t>(first.get() + 40 * stride);
  steps.most[0] = steps.least[0] + 3000;
  const auto is_there = [&](const std::byte* record) {
    const auto x = load<int32_t>(record);
    return x >= steps.least[0] && x <= steps.most[0];
  };
  KeptRecords some(chunks.laz, stride, steps, is_there, chunks.task);
  KeptRecords of_all(chunks.laz, stride, kAllSteps, is_there, chunks.task);
  REQUIRE(some.count() == of_all.count());
  REQUIRE(some.count() > 100);
  std::vector<std::byte> a(some.count() * stride), b(a.size());
  const auto into = [stride](std::vector<std::byte>& out) {
    return [&out, stride](const std::byte* records, size_t n, size_t at) {
      std::memcpy(out.data() + at * stride, records, n * stride);
    };
  };
  some.give(into(a), chunks.task);
  of_all.give(into(b), chunks.task);
  CHECK(a == b);
}
