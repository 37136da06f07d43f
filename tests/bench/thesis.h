// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <ctime>
#include <string>

#include "base/task.h"

namespace jalon::bench {

/// Processor seconds of all threads together: what else the machine does is not counted.
template <class Run>
double processor_seconds(Run run) {
  const std::clock_t start = std::clock();
  run();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The thesis measured with one thread.
inline Task::Hooks one_thread() {
  Task::Hooks hooks;
  hooks.threads = 1;
  return hooks;
}

/// Seconds beside those that Girardeau-Montaut 2006 prints; promised.py reads the lines.
class Table {
 public:
  explicit Table(std::string name) : name_(std::move(name)) {}

  void add(const std::string& row, double seconds, double printed_s) {
    std::printf("FIGURE %s, %s: %.3f s, printed %.2f s, %.1f x faster\n", name_.c_str(),
                row.c_str(), seconds, printed_s, printed_s / seconds);
    std::fflush(stdout);
    seconds_ += seconds;
    printed_s_ += printed_s;
  }
  void close() const {
    std::printf("FIGURE %s in all: %.1f x faster than printed\n", name_.c_str(),
                printed_s_ / seconds_);
  }

 private:
  std::string name_;
  double seconds_ = 0, printed_s_ = 0;
};

}  // namespace jalon::bench
