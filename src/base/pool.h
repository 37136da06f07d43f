// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace jalon {

class Task;

/// A few threads that work on numbered chunks. Which thread does which chunk is left open; what a chunk does must
/// depend on its number only, so that results are the same for any number of threads.
class Pool {
 public:
  explicit Pool(unsigned threads) : threads_(threads) {}
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  using Work = void (*)(void* context, size_t chunk);
  /// Runs work(context, c) for every c in [0, chunks), the calling thread taking part and keeping the task's progress
  /// and cancel. The exception of the lowest failing chunk is rethrown once all threads have stopped. Nested calls run
  /// inline.
  void run(Task& task, size_t chunks, Work work, void* context);

 private:
  void start(size_t wanted);
  void work_loop(unsigned slot);
  bool run_one();
  void run_inline(Task& task, size_t chunks, Work work, void* context);

  const unsigned threads_;
  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable wake_, idle_;
  bool stop_ = false;
  size_t generation_ = 0, busy_ = 0;

  Work work_ = nullptr;
  void* context_ = nullptr;
  size_t chunks_ = 0;
  Task* task_ = nullptr;
  std::atomic<bool> running_{false}, abandoned_{false};
  std::atomic<size_t> next_{0}, done_{0};
  std::exception_ptr error_;
  size_t error_chunk_ = 0;
};

}  // namespace jalon
