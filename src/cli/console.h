// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/handles.h"

namespace jalon::cli {

/// Options that every command has.
struct Common {
  bool quiet = false;
  bool json = false;
  unsigned threads = 0;
  unsigned memory_limit_mib = 0;
};

/// What a person sees while a command runs: a progress bar on a terminal, warnings, the result; nothing but errors when
/// quiet, one JSON object on standard output with --json. It owns the task; Ctrl-C cancels it.
class Console {
 public:
  explicit Console(const Common& common);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  jalon_task* task() const { return task_.get(); }
  /// As the options say; 0 = all processors.
  unsigned threads() const { return common_.threads; }
  /// With the same threads and memory, for a call on another thread.
  Task another_task(jalon_log_callback log, void* user) const;
  /// Names the step for the bar and starts its clock.
  void step(const char* name);
  /// Seconds since step() was called.
  double seconds() const;
  /// What the library has told beside warnings, line by line: what its steps took.
  const std::vector<std::string>& told() const { return told_; }
  /// Result for people: a line on standard output unless quiet or --json.
  void say(const std::string& line) const;
  /// What a person should look at: a line on standard error unless quiet.
  void warn(const std::string& line) const;
  /// Whether warnings of the library are passed over: of a file that is read again they were told.
  void pass_over_warnings(bool are_known) { are_warnings_known_ = are_known; }
  /// Result for scripts: printed with --json.
  void result(const nlohmann::ordered_json& object) const;

 private:
  static int32_t on_progress(double fraction, const char* stage, void* user);
  static void on_log(int32_t level, const char* text, void* user);
  void clear_bar();

  Common common_;
  Task task_;
  bool terminal_, bar_shown_ = false, are_warnings_known_ = false;
  std::string step_;
  std::vector<std::string> told_;
  std::chrono::steady_clock::time_point started_;
};

/// 12345678 as "12 345 678".
std::string grouped(uint64_t number);
/// Fixed decimals, no locale.
std::string fixed(double value, int decimals);

}  // namespace jalon::cli
