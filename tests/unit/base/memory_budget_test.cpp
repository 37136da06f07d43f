// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/memory_budget.h"

#include <doctest/doctest.h>

#include <limits>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"

namespace jalon {
namespace {

TEST_CASE("memory_budget__allows_what_is_left_and_remembers_a_no") {
  MemoryBudget budget(1000);
  CHECK(budget.allows(1000));
  CHECK_FALSE(budget.has_refused());
  budget.add(900);
  CHECK(budget.allows(100));
  CHECK_FALSE(budget.allows(101));
  CHECK_FALSE(budget.allows(std::numeric_limits<size_t>::max()));
  CHECK(budget.has_refused());
  budget.add(-900);
  CHECK(budget.allows(1000));
  CHECK(budget.peak_bytes() == 900);
  budget.lift();
  CHECK(budget.allows(5000));
}

// A call may give back what was there before it: that does not make it a larger share.
TEST_CASE("memory_budget__is_not_raised_by_what_others_took") {
  MemoryBudget budget(1000);
  budget.add(-5000);
  CHECK_FALSE(budget.allows(1001));
  CHECK(budget.peak_bytes() == 0);
}

TEST_CASE("memory_budget__says_what_was_in_use_and_wanted_at_the_first_no") {
  MemoryBudget budget(10 << 20);
  budget.add(8 << 20);
  CHECK_FALSE(budget.allows(3 << 20));
  budget.add(-(8 << 20));
  CHECK_FALSE(budget.allows(100 << 20));
  try {
    budget.fail_refused();
  } catch (const Error& error) {
    CHECK(error.status() == Status::kOutOfMemory);
    CHECK(std::string(error.what()) ==
          "the call had 8.0 MiB in use and needed 3.0 more; its memory limit is 10.0 MiB");
  }
}

TEST_CASE("require_memory__ends_a_call_whose_need_is_more_than_its_limit_and_takes_nothing") {
  CHECK_NOTHROW(require_memory(std::numeric_limits<uint64_t>::max()));  // without a limit
  MemoryBudget budget(1000);
  const BudgetScope scope(&budget);
  CHECK_NOTHROW(require_memory(1000));
  CHECK(budget.peak_bytes() == 0);
  CHECK_FALSE(budget.has_refused());
  CHECK_THROWS_AS(require_memory(1001), std::bad_alloc);
  CHECK(budget.peak_bytes() == 0);
  CHECK(budget.has_refused());
}

TEST_CASE("memory_budget__takes_the_sum_of_threads") {
  MemoryBudget budget(std::numeric_limits<uint64_t>::max());
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (int i = 0; i < 10000; ++i) budget.add(7), budget.add(-6);
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(budget.peak_bytes() >= 40000);
  CHECK(budget.peak_bytes() <= 40000 + 4 * 7);
}

TEST_CASE("budget_scope__is_of_its_thread_and_gives_back_the_one_before") {
  MemoryBudget outer(1), inner(1);
  CHECK(current_budget() == nullptr);
  {
    const BudgetScope scope(&outer);
    {
      const BudgetScope within(&inner);
      CHECK(current_budget() == &inner);
      std::thread([] { CHECK(current_budget() == nullptr); }).join();
    }
    CHECK(current_budget() == &outer);
    const BudgetScope nobody(nullptr);
    CHECK(current_budget() == nullptr);
  }
  CHECK(current_budget() == nullptr);
}

}  // namespace
}  // namespace jalon
