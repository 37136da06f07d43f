// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <list>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/console.h"

namespace jalon::cli {

/// Calls that run beside the command's own, each on a thread and with a task of its own: one that writes a large file
/// leaves the processors idle. A cancelled command cancels them; what they warn of is told when they are waited for, in
/// the order in which they were begun. With one thread each runs at once.
class Beside {
 public:
  using Call = std::function<void(jalon_task*)>;

  explicit Beside(const Console& console) : console_(console) {}
  ~Beside() {
    for (Running& one : running_) (void)!jalon_task_cancel(one.task.get());  // the futures wait
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  void run(Call call) {
    if (console_.threads() == 1) return call(console_.task());
    Running& one = running_.emplace_back();
    one.task = console_.another_task(on_log, &one.warnings);
    try {
      one.done = std::async(std::launch::async, call, one.task.get());
    } catch (const std::system_error&) {  // the system has no more threads
      running_.pop_back();
      call(console_.task());
    }
  }

  /// Until all are done; the failure of the first that failed is thrown.
  void wait() {
    while (!running_.empty()) {
      Running& first = running_.front();
      while (first.done.wait_for(kLook) != std::future_status::ready) pass_on_cancel();
      for (const std::string& warning : first.warnings) console_.warn(warning);
      std::future<void> done = std::move(first.done);
      running_.pop_front();
      done.get();
    }
  }

 private:
  static constexpr std::chrono::milliseconds kLook{20};  // between looks for a cancel

  struct Running {
    Task task;
    std::vector<std::string> warnings;
    std::future<void> done;  // last: its end waits for the call, which uses the others
  };

  static void on_log(int32_t level, const char* text, void* warnings) {
    if (level >= JALON_LOG_WARNING)
      static_cast<std::vector<std::string>*>(warnings)->emplace_back(text);
  }

  void pass_on_cancel() {
    int32_t is_cancelled = 0;
    must(jalon_task_is_cancelled(console_.task(), &is_cancelled));
    if (is_cancelled == 0) return;
    for (Running& one : running_) must(jalon_task_cancel(one.task.get()));
  }

  const Console& console_;
  std::list<Running> running_;
};

}  // namespace jalon::cli
