// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "base/field.h"
#include "base/memory_budget.h"
#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "jalon/jalon.h"

namespace jalon::capi {

/// The atomic count of all handles.
struct Counted {
  std::atomic<uint64_t> owners{1};
};

template <class T>
T* retain(T* handle) noexcept {
  if (handle != nullptr) handle->owners.fetch_add(1, std::memory_order_relaxed);
  return handle;
}

template <class T>
void release(T* handle) noexcept {
  if (handle != nullptr && handle->owners.fetch_sub(1, std::memory_order_acq_rel) == 1)
    delete handle;
}

/// A task in use by one call: refuses a second one, hands the hooks on. NULL gives the defaults.
class TaskUse {
 public:
  explicit TaskUse(jalon_task* task);
  ~TaskUse();
  TaskUse(const TaskUse&) = delete;
  TaskUse& operator=(const TaskUse&) = delete;
  Task& task() { return task_; }
  /// In a catch block of std::bad_alloc: throws what the memory limit has to say, if it was the limit.
  void blame_memory_limit();

 private:
  jalon_task* handle_;
  MemoryBudget budget_;  ///< asked where there is a limit
  BudgetScope scope_;
  Task task_;  ///< its threads end before the scope does
};

}  // namespace jalon::capi

struct jalon_task : jalon::capi::Counted {
  std::atomic<bool> cancelled{false}, running{false};
  jalon::Task::Hooks hooks;
  uint64_t memory_limit_bytes = 0, memory_peak_bytes = 0;
};

struct jalon_params : jalon::capi::Counted {
  std::string operation;                    ///< "normals", or "segmenter ransac" for a worker's
  std::shared_ptr<jalon::ParamSet> values;  ///< shared with the worker, if it has one
  std::string json;                         ///< what jalon_params_to_json handed out
  std::vector<std::string> default_texts;   ///< for jalon_param_info
};

struct jalon_fields : jalon::capi::Counted {
  jalon::FieldTable table;
};

struct jalon_cloud : jalon::capi::Counted {
  std::shared_ptr<const jalon::Cloud> cloud;  ///< replaced as a whole by functions that change it
};
