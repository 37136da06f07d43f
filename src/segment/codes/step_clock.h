// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

#include "base/task.h"
#include "base/text_number.h"

namespace jalon {

/// Tells the host's log what each step took: "step points cut: 0.123 s". Times are in no result: the same input gives
/// the same bits.
class StepClock {
 public:
  explicit StepClock(Task& task) : task_(task) {}
  void done(const char* step) {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    task_.log(Task::kInfo, "step %s: %s s", step, text_of(seconds, 3).c_str());
    last_ = now;
  }

 private:
  Task& task_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace jalon
