// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/task.h"

namespace jalon::test {

/// A task whose warnings are kept.
class KeptLog {
 public:
  Task& task() { return task_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  Task::Hooks hooks() {
    Task::Hooks out;
    out.log_user = this;
    out.log = [](int32_t level, const char* line, void* self) {
      if (level >= Task::kWarning) static_cast<KeptLog*>(self)->warnings_.emplace_back(line);
    };
    return out;
  }

  std::vector<std::string> warnings_;
  Task task_{hooks()};
};

}  // namespace jalon::test
