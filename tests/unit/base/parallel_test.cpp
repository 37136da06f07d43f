// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "base/random.h"

using namespace jalon;

namespace {

Task::Hooks with_threads(unsigned n) {
  Task::Hooks hooks;
  hooks.threads = n;
  return hooks;
}

}  // namespace

TEST_CASE("parallel_for visits every element once, for any number of threads") {
  for (const unsigned threads : {1u, 2u, 7u}) {
    Task task(with_threads(threads));
    std::vector<int> visits(100'003);
    parallel_for(task, visits.size(), 1000, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) ++visits[i];
    });
    CHECK(std::accumulate(visits.begin(), visits.end(), 0) == 100'003);
    CHECK(*std::max_element(visits.begin(), visits.end()) == 1);
  }
}

TEST_CASE("parallel_reduce gives the same bits for 1, 2 and 7 threads") {
  std::vector<double> values(50'000);
  RandomStream random(7, 0);
  // Alike in size and of both signs: a sum in another order has other bits, which one far larger value would hide.
  for (double& v : values) v = random.normal();
  double first = 0;
  for (const unsigned threads : {1u, 2u, 7u}) {
    Task task(with_threads(threads));
    const double sum =
        parallel_reduce(task, values.size(), 777, 0.0, [&](size_t begin, size_t end) {
          double s = 0;
          for (size_t i = begin; i < end; ++i) s += values[i];
          return s;
        });
    if (threads == 1) first = sum;
    CHECK(sum == first);
  }
}

TEST_CASE("an exception in a worker reaches the caller, and the pool works on afterwards") {
  Task task(with_threads(4));
  for (int round = 0; round < 50; ++round) {
    CHECK_THROWS_AS(parallel_for(task, 1000, 1,
                                 [](size_t begin, size_t) {
                                   if (begin == 500) throw std::runtime_error("chunk 500");
                                 }),
                    std::runtime_error);
    std::atomic<size_t> n{0};
    parallel_for(task, 1000, 1, [&](size_t, size_t) { ++n; });
    CHECK(n == 1000);
  }
}

TEST_CASE("nested loops run inline") {
  Task task(with_threads(3));
  std::atomic<size_t> n{0};
  parallel_for(task, 20, 1, [&](size_t, size_t) {
    parallel_for(task, 100, 10, [&](size_t b, size_t e) { n += e - b; });
  });
  CHECK(n == 2000);
}

TEST_CASE("a cancel flag ends a loop with kCancelled") {
  std::atomic<bool> cancel{false};
  Task::Hooks hooks = with_threads(2);
  hooks.cancel = &cancel;
  Task task(hooks);
  std::atomic<size_t> done{0};
  Status status = Status::kOk;
  try {
    parallel_for(task, 100'000, 1, [&](size_t, size_t) {
      if (++done == 100) cancel = true;
    });
  } catch (const Error& error) {
    status = error.status();
  }
  CHECK(status == Status::kCancelled);
  CHECK(done < 1000);
}

// The flag is the host's: it may go up and down at any moment, also between two looks of the pool at it.
TEST_CASE(
    "a cancel that is taken back at once ends a loop with kCancelled or leaves it whole, never "
    "half done") {
  std::atomic<bool> cancel{false}, over{false};
  Task::Hooks hooks = with_threads(4);
  hooks.cancel = &cancel;
  Task task(hooks);
  std::thread host([&] {
    for (RandomStream random(5, 0); !over;) {
      cancel = true;
      for (uint64_t i = random.below(200); i > 0; --i) std::this_thread::yield();
      cancel = false;
      for (uint64_t i = random.below(2000); i > 0; --i) std::this_thread::yield();
    }
  });
  int whole = 0, cancelled = 0, half = 0;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while ((whole < 200 || cancelled < 200) && std::chrono::steady_clock::now() < deadline) {
    std::atomic<size_t> done{0};
    try {
      parallel_for(task, 64, 1, [&](size_t, size_t) { ++done; });
      (done == 64 ? whole : half)++;
    } catch (const Error& error) {
      CHECK(error.status() == Status::kCancelled);
      ++cancelled;
    }
  }
  over = true;
  host.join();
  CHECK(half == 0);
  CHECK(whole > 0);
  CHECK(cancelled > 0);
  std::atomic<size_t> done{0};
  parallel_for(task, 1000, 1, [&](size_t, size_t) { ++done; });
  CHECK(done == 1000);
  MESSAGE("FIGURE loops under a flickering cancel: " << whole << " whole, " << cancelled
                                                     << " cancelled, " << half << " half done");
}

TEST_CASE("progress grows monotonically on the calling thread and stays below 1 until finish") {
  struct Seen {
    std::vector<double> fractions;
    std::thread::id thread = std::this_thread::get_id();
    bool same_thread = true;
  } seen;
  Task::Hooks hooks = with_threads(2);
  hooks.progress_user = &seen;
  hooks.progress = [](double fraction, const char*, void* user) -> int32_t {
    auto& s = *static_cast<Seen*>(user);
    s.fractions.push_back(fraction);
    s.same_thread = s.same_thread && std::this_thread::get_id() == s.thread;
    return 0;
  };
  Task task(hooks);
  const auto work = [&] {
    parallel_for(task, 200, 1,
                 [](size_t, size_t) { std::this_thread::sleep_for(std::chrono::milliseconds(2)); });
  };
  {
    ProgressSpan first(task, 0, 0.5, "first");
    work();
  }
  {
    ProgressSpan second(task, 0.5, 1, "second");
    work();
  }
  REQUIRE(seen.fractions.size() >= 3);
  CHECK(std::is_sorted(seen.fractions.begin(), seen.fractions.end()));
  CHECK(seen.fractions.back() < 1);
  CHECK(seen.same_thread);
  task.finish();
  CHECK(seen.fractions.back() == 1);
}

TEST_CASE("random streams are pure functions of seed and stream, uniform and independent") {
  RandomStream a(1, 2), b(1, 2), c(1, 3), d(2, 2);
  const uint64_t first = a.bits();
  CHECK(first == b.bits());
  CHECK(first != c.bits());
  CHECK(first != d.bits());
  constexpr int kDraws = 200'000, kBins = 100;
  std::vector<int> bins(kBins);
  double sum = 0, squares = 0, lag = 0, previous = 0;
  RandomStream u(11, 0), g(12, 0);
  for (int i = 0; i < kDraws; ++i) {
    ++bins[static_cast<size_t>(u.below(kBins))];
    const double x = g.normal();
    sum += x;
    squares += x * x;
    lag += x * previous;
    previous = x;
  }
  double chi2 = 0;
  for (int n : bins) chi2 += std::pow(n - kDraws / kBins, 2) / (kDraws / kBins);
  CHECK(chi2 < 148.23);  // 99.9 % quantile of chi-square with 99 degrees of freedom
  CHECK(std::fabs(sum / kDraws) < 4 / std::sqrt(kDraws));
  CHECK(std::fabs(squares / kDraws - 1) < 4 * std::sqrt(2.0 / kDraws));
  CHECK(std::fabs(lag / kDraws) < 4 / std::sqrt(kDraws));
}
