// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>
#include <utility>
#include <vector>

#include "base/error.h"
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
