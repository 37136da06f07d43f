// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "base/task.h"

namespace jalon::test {

/// The status that f ends in.
template <class F>
Status status_of(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.status();
  }
  return Status::kOk;
}

inline Task::Hooks threads(unsigned n) {
  Task::Hooks hooks;
  hooks.threads = n;
  return hooks;
}

}  // namespace jalon::test
