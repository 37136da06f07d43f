// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/pool.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/task.h"

namespace jalon {

Pool::~Pool() {
  {
    std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  for (auto& worker : workers_) worker.join();
}

void Pool::start(size_t wanted) {
  workers_.reserve(wanted);
  while (workers_.size() < wanted) {
    try {
      const auto slot = static_cast<unsigned>(workers_.size());
      // The pool is one call's, and so is what its threads take.
      workers_.emplace_back([this, slot, budget = current_budget()] {
        const BudgetScope scope(budget);
        work_loop(slot);
      });
    } catch (const std::system_error&) {
      return;  // the system has no more threads: fewer do the same work
    }
  }
}

void Pool::work_loop(unsigned slot) {
  size_t seen = 0;
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [&] { return stop_ || generation_ != seen; });
    if (stop_) return;
    seen = generation_;
    if (work_ == nullptr || slot + 1 >= chunks_) continue;
    ++busy_;
    lock.unlock();
    while (run_one()) {
    }
    lock.lock();
    if (--busy_ == 0) idle_.notify_all();
  }
}

bool Pool::run_one() {
  if (abandoned_.load(std::memory_order_relaxed)) return false;
  const size_t chunk = next_.fetch_add(1, std::memory_order_relaxed);
  if (chunk >= chunks_) return false;
  try {
    if (task_->cancelled()) {
      abandoned_.store(true, std::memory_order_relaxed);
      return false;
    }
    work_(context_, chunk);
    done_.fetch_add(1, std::memory_order_relaxed);
  } catch (...) {
    std::lock_guard lock(mutex_);
    if (!error_ || chunk < error_chunk_) {
      error_ = std::current_exception();
      error_chunk_ = chunk;
    }
    abandoned_.store(true, std::memory_order_relaxed);
    return false;
  }
  return true;
}

void Pool::run_inline(Task& task, size_t chunks, Work work, void* context) {
  for (size_t c = 0; c < chunks; ++c) {
    task.checkpoint(static_cast<double>(c) / static_cast<double>(chunks));
    work(context, c);
  }
}

void Pool::run(Task& task, size_t chunks, Work work, void* context) {
  if (chunks == 0) return;
  if (threads_ <= 1 || chunks == 1 || !task.on_calling_thread() ||
      running_.load(std::memory_order_relaxed)) {
    run_inline(task, chunks, work, context);
    return;
  }
  start(std::min<size_t>(threads_, chunks) - 1);
  {
    std::lock_guard lock(mutex_);
    work_ = work;
    context_ = context;
    chunks_ = chunks;
    task_ = &task;
    next_ = 0;
    done_ = 0;
    abandoned_ = false;
    error_ = nullptr;
    running_ = true;
    ++generation_;
  }
  wake_.notify_all();
  const auto fraction = [&] {
    return static_cast<double>(done_.load()) / static_cast<double>(chunks);
  };
  std::exception_ptr host;  // from the progress callback or a cancel, on this thread
  try {
    while (run_one()) task.checkpoint(fraction());
  } catch (...) {
    host = std::current_exception();
    abandoned_ = true;
  }
  std::unique_lock lock(mutex_);
  while (busy_ != 0) {
    idle_.wait_for(lock, std::chrono::milliseconds(50));
    if (busy_ == 0 || host) continue;
    lock.unlock();
    try {
      task.checkpoint(fraction());
    } catch (...) {
      host = std::current_exception();
      abandoned_ = true;
    }
    lock.lock();
  }
  work_ = nullptr;
  running_ = false;
  const std::exception_ptr error = std::exchange(error_, nullptr);
  lock.unlock();
  if (error) std::rethrow_exception(error);
  if (host) std::rethrow_exception(host);
  // Chunks were left out for a cancel, even if the task has been reset since.
  if (abandoned_) throw Error(Status::kCancelled, "cancelled");
}

}  // namespace jalon
