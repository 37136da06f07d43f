// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/task.h"

#include <algorithm>
#include <cstdarg>
#include <thread>

#include "base/error.h"
#include "base/pool.h"
#include "base/whole_utf8.h"

namespace jalon {

namespace {

constexpr auto kReportInterval = std::chrono::milliseconds(60);  // the API promises 50-100 ms

// Address of a thread-local byte: a cheap, copyable identity of the running thread.
const void* this_thread() {
  static thread_local const char identity = 0;
  return &identity;
}

}  // namespace

Task::Task(const Hooks& hooks)
    : hooks_(hooks),
      threads_(hooks.threads != 0 ? hooks.threads
                                  : std::max(1u, std::thread::hardware_concurrency())),
      calling_thread_(this_thread()),
      last_report_(std::chrono::steady_clock::now()) {}

Task::~Task() = default;

bool Task::on_calling_thread() const { return calling_thread_ == this_thread(); }

Pool& Task::pool() {
  if (!pool_) pool_ = std::make_unique<Pool>(threads_);
  return *pool_;
}

void Task::report(double fraction) {
  fraction = std::clamp(fraction, 0.0, 1.0);
  if (fraction <= reported_) fraction = std::max(reported_, 0.0);
  reported_ = fraction;
  int32_t stop = 0;
  try {
    stop = hooks_.progress(fraction, stage_, hooks_.progress_user);
  } catch (...) {
    throw Error(Status::kCallback, "the progress callback threw an exception");
  }
  if (stop != 0) throw Error(Status::kCancelled, "cancelled by the progress callback");
}

void Task::checkpoint(double fraction) {
  if (cancelled()) throw Error(Status::kCancelled, "cancelled");
  if (hooks_.progress == nullptr || !on_calling_thread()) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_report_ < kReportInterval) return;
  last_report_ = now;
  // 1.0 is for success alone, so a running operation stops just short of it.
  const double whole = window_from_ + std::clamp(fraction, 0.0, 1.0) * (window_to_ - window_from_);
  report(std::min(whole, 0.999));
}

void Task::finish() {
  if (hooks_.progress == nullptr) return;
  try {
    hooks_.progress(1.0, stage_, hooks_.progress_user);
  } catch (...) {
    throw Error(Status::kCallback, "the progress callback threw an exception");
  }
}

void Task::log(LogLevel level, const char* format, ...) {
  if (hooks_.log == nullptr || !on_calling_thread()) return;
  va_list arguments;
  va_start(arguments, format);
  MessageText message(format, arguments);
  va_end(arguments);
  for (char* c = message.text; *c != 0; ++c)
    if (*c == '\n' || *c == '\r') *c = ' ';
  try {
    hooks_.log(level, message.text, hooks_.log_user);
  } catch (...) {
    throw Error(Status::kCallback, "the log callback threw an exception");
  }
}

ProgressSpan::ProgressSpan(Task& task, double from, double to, const char* stage)
    : task_(task),
      from_(task.window_from_),
      to_(task.window_to_),
      stage_(task.stage_),
      active_(task.on_calling_thread()) {
  if (!active_) return;
  task.window_from_ = from_ + from * (to_ - from_);
  task.window_to_ = from_ + to * (to_ - from_);
  if (stage != nullptr) task.stage_ = stage;
}

ProgressSpan::~ProgressSpan() {
  if (!active_) return;
  task_.window_from_ = from_;
  task_.window_to_ = to_;
  task_.stage_ = stage_;
}

}  // namespace jalon
