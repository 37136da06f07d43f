// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>

#include "base/printf_format.h"

namespace jalon {

class Pool;

/// How a running operation talks to its host, and its threads: the last parameter of every long function.
///
/// checkpoint() and the parallel loops report progress and notice a cancel; both act only on the thread that started
/// the operation (the host's promise: callbacks on the calling thread). A cancel or a callback that says stop ends in
/// Error(kCancelled). Progress windows: a ProgressSpan maps the fractions of a sub-step into its part of the whole.
class Task {
 public:
  using Progress = int32_t (*)(double fraction, const char* stage, void* user);
  using Log = void (*)(int32_t level, const char* text, void* user);
  enum LogLevel : int32_t { kDebug = 1, kInfo = 2, kWarning = 3 };

  struct Hooks {
    unsigned threads = 0;  ///< 0 = all processors
    Progress progress = nullptr;
    void* progress_user = nullptr;
    Log log = nullptr;
    void* log_user = nullptr;
    const std::atomic<bool>* cancel = nullptr;
  };

  Task() : Task(Hooks{}) {}
  explicit Task(const Hooks& hooks);
  ~Task();
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

  unsigned threads() const { return threads_; }
  bool cancelled() const {
    return hooks_.cancel != nullptr && hooks_.cancel->load(std::memory_order_relaxed);
  }
  /// Throws when cancelled; tells the host the fraction (0..1 of the current window) when it is due. Calling thread
  /// only; elsewhere it only throws when cancelled.
  void checkpoint(double fraction);
  /// Sends a line to the host's log, if any. Calling thread only.
  void log(LogLevel level, const char* format, ...) JALON_PRINTF(3, 4);
  /// Reports 1.0; capi calls it once, on success.
  void finish();
  /// The threads of this operation, started when first needed, ended with the task: nothing outlives a call, so a
  /// fork between calls is harmless and no runtime can clash with the host's.
  Pool& pool();
  bool on_calling_thread() const;

 private:
  friend class ProgressSpan;
  void report(double fraction);

  Hooks hooks_;
  unsigned threads_;
  std::unique_ptr<Pool> pool_;
  const void* calling_thread_;
  double window_from_ = 0, window_to_ = 1, reported_ = -1;
  const char* stage_ = "working";
  std::chrono::steady_clock::time_point last_report_;
};

/// Gives the code in its scope the part [from, to] of the enclosing progress window, under a stage name (static text;
/// NULL keeps it).
class ProgressSpan {
 public:
  ProgressSpan(Task& task, double from, double to, const char* stage = nullptr);
  ~ProgressSpan();
  ProgressSpan(const ProgressSpan&) = delete;
  ProgressSpan& operator=(const ProgressSpan&) = delete;

 private:
  Task& task_;
  double from_, to_;
  const char* stage_;
  bool active_;
};

}  // namespace jalon
