// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/pool.h"

#include <doctest/doctest.h>

#include <atomic>
#include <set>
#include <string>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/task.h"

using namespace jalon;

namespace {

Task::Hooks on_threads(unsigned threads) {
  Task::Hooks hooks;
  hooks.threads = threads;
  return hooks;
}

struct Visits {
  std::vector<std::atomic<int>> of;
  explicit Visits(size_t chunks) : of(chunks) {}
  static void count(void* p, size_t chunk) { ++static_cast<Visits*>(p)->of[chunk]; }
};

// Chunks that wait for one another till three threads are there.
struct Meeting {
  std::mutex mutex;
  std::set<std::thread::id> ids;
  std::set<MemoryBudget*> budgets;
  std::condition_variable met;

  static void meet(void* p, size_t) {
    auto& s = *static_cast<Meeting*>(p);
    std::unique_lock lock(s.mutex);
    s.ids.insert(std::this_thread::get_id());
    s.budgets.insert(current_budget());
    s.met.notify_all();
    s.met.wait_for(lock, std::chrono::seconds(1), [&] { return s.ids.size() >= 3; });
  }
};

}  // namespace

TEST_CASE("pool__does_every_chunk_once_run_after_run") {
  for (const unsigned threads : {1u, 2u, 5u}) {
    Task task(on_threads(threads));
    Pool pool(threads);
    for (const size_t chunks : {size_t{0}, size_t{1}, size_t{2}, size_t{3}, size_t{1000}}) {
      Visits visits(chunks);
      pool.run(task, chunks, Visits::count, &visits);
      for (const auto& n : visits.of) CHECK(n == 1);
    }
  }
}

TEST_CASE("pool__uses_no_more_threads_than_it_has_and_the_callers_is_one_of_them") {
  Meeting seen;
  Task task(on_threads(3));
  Pool pool(3);
  pool.run(task, 3, Meeting::meet, &seen);
  pool.run(task, 20, Meeting::meet, &seen);
  CHECK(seen.ids.size() == 3);
  CHECK(seen.ids.count(std::this_thread::get_id()) == 1);
}

TEST_CASE("pool__rethrows_the_exception_of_the_lowest_failing_chunk") {
  // Both chunks are under way before either fails, the higher one first.
  struct Order {
    std::atomic<int> started{0};
    std::atomic<bool> high_failed{false};
  } order;
  Task task(on_threads(2));
  Pool pool(2);
  const auto work = [](void* p, size_t chunk) {
    auto& o = *static_cast<Order*>(p);
    ++o.started;
    while (o.started < 2) std::this_thread::yield();
    if (chunk == 1) {
      o.high_failed = true;
      fail(Status::kIo, "high");
    }
    while (!o.high_failed) std::this_thread::yield();
    fail(Status::kFormat, "low");
  };
  try {
    pool.run(task, 2, work, &order);
    FAIL("no exception");
  } catch (const Error& error) {
    CHECK(std::string(error.what()) == "low");
  }
  Visits visits(50);  // and it works on
  pool.run(task, 50, Visits::count, &visits);
  for (const auto& n : visits.of) CHECK(n == 1);
}

TEST_CASE("pool__a_cancelled_task_leaves_chunks_out_and_ends_with_kCancelled") {
  for (const unsigned threads : {1u, 3u}) {
    std::atomic<bool> cancel{true};
    Task::Hooks hooks = on_threads(threads);
    hooks.cancel = &cancel;
    Task task(hooks);
    Pool pool(threads);
    Visits visits(100);
    Status status = Status::kOk;
    try {
      pool.run(task, 100, Visits::count, &visits);
    } catch (const Error& error) {
      status = error.status();
    }
    CHECK(status == Status::kCancelled);
    for (const auto& n : visits.of) CHECK(n == 0);
    cancel = false;
    pool.run(task, 100, Visits::count, &visits);
    for (const auto& n : visits.of) CHECK(n == 1);
  }
}

TEST_CASE("pool__what_its_threads_take_is_of_the_budget_of_the_call") {
  MemoryBudget budget(1 << 20);
  const BudgetScope scope(&budget);
  Meeting seen;
  Task task(on_threads(3));
  Pool pool(3);
  pool.run(task, 3, Meeting::meet, &seen);
  CHECK(seen.ids.size() == 3);
  CHECK(seen.budgets == std::set<MemoryBudget*>{&budget});
}
