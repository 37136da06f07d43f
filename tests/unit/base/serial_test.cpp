// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "base/serial.h"

using namespace jalon;

TEST_CASE("serial_for__takes_all_chunks_in_order_and_the_last_one_as_it_is") {
  Task task;
  std::vector<std::pair<size_t, size_t>> seen;
  serial_for(task, 10, 4, [&](size_t begin, size_t end) { seen.push_back({begin, end}); });
  CHECK(seen == std::vector<std::pair<size_t, size_t>>{{0, 4}, {4, 8}, {8, 10}});
  serial_for(task, 0, 4, [&](size_t, size_t) { seen.clear(); });
  CHECK(seen.size() == 3);
}

TEST_CASE("serial_for__a_cancel_acts_before_the_next_chunk") {
  std::atomic<bool> cancel{false};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  size_t done = 0;
  const auto run = [&] {
    serial_for(task, 1000, 10, [&](size_t begin, size_t end) {
      done += end - begin;
      if (begin == 50) cancel = true;
    });
  };
  CHECK_THROWS_AS(run(), Error);
  CHECK(done == 60);
}

namespace {

std::vector<uint64_t> drawn_numbers(size_t count) {
  RandomStream random(11, 0);
  std::vector<uint64_t> out(count);
  for (uint64_t& number : out) number = static_cast<uint64_t>(random.uniform() * 1e6);
  return out;
}

}  // namespace

TEST_CASE("serial_sort__is_the_sort_of_the_standard_of_a_part_of_a_run_and_of_many") {
  Task task;
  for (const size_t count : {0, 1, 1000, 32768, 32769, 300000}) {
    CAPTURE(count);
    auto numbers = drawn_numbers(count), expected = numbers;
    std::sort(expected.begin(), expected.end());
    serial_sort(task, numbers.begin(), numbers.end());
    CHECK(numbers == expected);
    std::sort(expected.begin(), expected.end(), std::greater<>());
    serial_sort(task, numbers.begin(), numbers.end(), std::greater<>());
    CHECK(numbers == expected);
  }
}

TEST_CASE("serial_sort__a_cancel_acts_between_runs_and_between_merges") {
  std::atomic<bool> cancel{false};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  const size_t compared_by_a_whole = [&] {
    size_t compared = 0;
    auto numbers = drawn_numbers(300000);
    serial_sort(task, numbers.begin(), numbers.end(), [&](uint64_t a, uint64_t b) {
      ++compared;
      return a < b;
    });
    return compared;
  }();
  for (const size_t tenths : {1, 9}) {  // of the runs, of the merges
    cancel = false;
    size_t compared = 0, after = 0;
    auto numbers = drawn_numbers(300000);
    const auto sort = [&] {
      serial_sort(task, numbers.begin(), numbers.end(), [&](uint64_t a, uint64_t b) {
        if (cancel) ++after;
        if (++compared > tenths * compared_by_a_whole / 10) cancel = true;
        return a < b;
      });
    };
    CHECK_THROWS_AS(sort(), Error);
    CHECK(after < compared_by_a_whole / 10);
  }
}
