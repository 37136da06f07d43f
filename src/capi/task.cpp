// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/task.h"

#include "capi/support/counted_memory.h"
#include "capi/support/guard.h"

namespace jalon::capi {

namespace {

Task::Hooks start(jalon_task* task) {
  if (task == nullptr) return {};
  if (task->running.exchange(true)) fail(Status::kBusy, "the task already runs a call");
  Task::Hooks hooks = task->hooks;
  hooks.cancel = &task->cancelled;
  return hooks;
}

uint64_t limit_of(const jalon_task* task) { return task == nullptr ? 0 : task->memory_limit_bytes; }

}  // namespace

TaskUse::TaskUse(jalon_task* task)
    : handle_(task),
      budget_(limit_of(task)),
      scope_(limit_of(task) != 0 ? &budget_ : current_budget()),
      task_(start(task)) {}

TaskUse::~TaskUse() {
  if (handle_ == nullptr) return;
  handle_->memory_peak_bytes = budget_.peak_bytes();
  handle_->running = false;
}

void TaskUse::blame_memory_limit() {
  if (!budget_.has_refused()) return;
  budget_.lift();
  budget_.fail_refused();
}

}  // namespace jalon::capi

using namespace jalon;
using namespace jalon::capi;

namespace {

constexpr uint32_t kMaxThreads = 256;

void require_idle(const jalon_task* task) {
  require(task, "task");
  if (task->running) fail(Status::kBusy, "the task is running a call");
}

}  // namespace

jalon_status jalon_task_create(jalon_task** out) {
  return guard([&] {
    require(out, "out");
    *out = new jalon_task;
  });
}

jalon_task* jalon_task_retain(jalon_task* task) { return retain(task); }
void jalon_task_release(jalon_task* task) { release(task); }

jalon_status jalon_task_set_threads(jalon_task* task, uint32_t threads) {
  return guard([&] {
    require_idle(task);
    if (threads > kMaxThreads)
      fail(Status::kInvalidArgument, "%u threads; at most %u", threads, kMaxThreads);
    task->hooks.threads = threads;
  });
}

jalon_status jalon_task_set_progress(jalon_task* task, jalon_progress_callback callback,
                                     void* user) {
  return guard([&] {
    require_idle(task);
    task->hooks.progress = callback;
    task->hooks.progress_user = user;
  });
}

jalon_status jalon_task_set_log(jalon_task* task, jalon_log_callback callback, void* user) {
  return guard([&] {
    require_idle(task);
    task->hooks.log = callback;
    task->hooks.log_user = user;
  });
}

jalon_status jalon_task_set_memory_limit(jalon_task* task, uint64_t bytes) {
  return guard([&] {
    require_idle(task);
    if (bytes != 0 && !is_memory_counted())
      fail(Status::kUnsupported,
           "memory is not counted here: a static library, a system other than Linux, or an "
           "operator new that is the host's own");
    task->memory_limit_bytes = bytes;
  });
}

jalon_status jalon_task_memory_peak(const jalon_task* task, uint64_t* out) {
  return guard([&] {
    require_idle(task);
    require(out, "out");
    *out = task->memory_peak_bytes;
  });
}

jalon_status jalon_task_cancel(jalon_task* task) {
  return guard([&] {
    require(task, "task");
    task->cancelled = true;
  });
}

jalon_status jalon_task_reset(jalon_task* task) {
  return guard([&] {
    require(task, "task");
    task->cancelled = false;
  });
}

jalon_status jalon_task_is_cancelled(const jalon_task* task, int32_t* out) {
  return guard([&] {
    require(task, "task");
    require(out, "out");
    *out = task->cancelled ? 1 : 0;
  });
}
