// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/task.h"

namespace jalon {

/// f(begin, end) over chunks of [0, n) one after the other on this thread, with a look for a cancel before each: for
/// long loops whose turns hang on the ones before. A chunk should take less than 20 ms. It tells no progress of its
/// own.
template <class F>
void serial_for(Task& task, size_t n, size_t grain, F&& f) {
  for (size_t begin = 0; begin < n; begin += grain) {
    task.checkpoint(0);
    f(begin, std::min(n, begin + grain));
  }
}

}  // namespace jalon
