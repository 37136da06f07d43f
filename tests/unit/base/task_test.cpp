// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/task.h"

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"

using namespace jalon;

namespace {

struct Host {
  std::vector<double> fractions;
  std::vector<std::string> stages, lines;
  int32_t answer = 0;

  Task::Hooks hooks() {
    Task::Hooks out;
    out.threads = 2;
    out.progress_user = out.log_user = this;
    out.progress = [](double fraction, const char* stage, void* user) {
      auto& host = *static_cast<Host*>(user);
      host.fractions.push_back(fraction);
      host.stages.push_back(stage);
      return host.answer;
    };
    out.log = [](int32_t, const char* text, void* user) {
      static_cast<Host*>(user)->lines.push_back(text);
    };
    return out;
  }
};

// A checkpoint that is due.
void report(Task& task, double fraction) {
  std::this_thread::sleep_for(std::chrono::milliseconds(65));
  task.checkpoint(fraction);
}

template <class F>
Status task_status_of(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.status();
  }
  return Status::kOk;
}

}  // namespace

TEST_CASE("progress_span__maps_fractions_into_the_enclosing_window_and_gives_it_back") {
  Host host;
  Task task(host.hooks());
  {
    ProgressSpan outer(task, 0.5, 0.9, "outer");
    ProgressSpan inner(task, 0.25, 0.75);  // 0.6 to 0.8 of the whole, the stage kept
    report(task, 0.5);
  }
  report(task, 0.95);
  task.finish();
  REQUIRE(host.fractions.size() == 3);
  CHECK(host.fractions[0] == doctest::Approx(0.7));
  CHECK(host.stages[0] == "outer");
  CHECK(host.fractions[1] == doctest::Approx(0.95));
  CHECK(host.stages[1] != "outer");
  CHECK(host.fractions[2] == 1);
}

TEST_CASE("task__checkpoints_in_quick_succession_do_not_trouble_the_host") {
  Host host;
  Task task(host.hooks());
  for (int i = 0; i < 10000; ++i) task.checkpoint(i / 10000.0);
  CHECK(host.fractions.size() <= 2);
  report(task, 1);
  REQUIRE(!host.fractions.empty());
  CHECK(host.fractions.back() < 1);  // 1 is for success alone
}

TEST_CASE("task__a_host_that_says_stop_or_throws_ends_the_operation") {
  Host host;
  host.answer = 1;
  Task stopped(host.hooks());
  CHECK(task_status_of([&] { report(stopped, 0.1); }) == Status::kCancelled);
  Task::Hooks hooks = host.hooks();
  hooks.progress = [](double, const char*, void*) -> int32_t { throw std::runtime_error("host"); };
  hooks.log = [](int32_t, const char*, void*) { throw std::runtime_error("host"); };
  Task throwing(hooks);
  CHECK(task_status_of([&] { report(throwing, 0.1); }) == Status::kCallback);
  CHECK(task_status_of([&] { throwing.log(Task::kInfo, "text"); }) == Status::kCallback);
  CHECK(task_status_of([&] { throwing.finish(); }) == Status::kCallback);
}

TEST_CASE("task__speaks_to_the_host_on_the_calling_thread_only_and_in_single_lines") {
  Host host;
  std::atomic<bool> cancel{false};
  Task::Hooks hooks = host.hooks();
  hooks.cancel = &cancel;
  Task task(hooks);
  CHECK(task.threads() == 2);
  Status elsewhere = Status::kOk;
  std::thread([&] {
    task.log(Task::kInfo, "from elsewhere");
    report(task, 0.5);
    cancel = true;
    elsewhere = task_status_of([&] { task.checkpoint(0.5); });
  }).join();
  CHECK(host.lines.empty());
  CHECK(host.fractions.empty());
  CHECK(elsewhere == Status::kCancelled);  // a cancel is noticed there too
  task.log(Task::kWarning, "two\nlines: %d", 2);
  REQUIRE(host.lines.size() == 1);
  CHECK(host.lines[0] == "two lines: 2");
  task.log(Task::kInfo, "%.5s of a file", "caf\xC3\xA9s");
  task.log(Task::kInfo, "%.4s of a file", "caf\xC3\xA9s");
  const std::string long_name(1022, 'x');
  task.log(Task::kInfo, "%s", (long_name + "\xC3\xA9").c_str());
  REQUIRE(host.lines.size() == 4);
  CHECK(host.lines[1] == "caf\xC3\xA9 of a file");
  CHECK(host.lines[2] == "caf? of a file");  // no half characters
  CHECK(host.lines[3] == long_name);
}
