// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/pool.h"
#include "base/task.h"

namespace jalon {

/// f(begin, end) over fixed chunks of [0, n): the cuts depend on n and grain only, never on the threads. A chunk should
/// take 0.1-20 ms, so that cancel is quick and hand-over cheap.
template <class F>
void parallel_for(Task& task, size_t n, size_t grain, F&& f) {
  struct Context {
    F* f;
    size_t n, grain;
  } context{&f, n, std::max<size_t>(1, grain)};
  const size_t chunks = (n + context.grain - 1) / context.grain;
  task.pool().run(
      task, chunks,
      [](void* p, size_t chunk) {
        auto& c = *static_cast<Context*>(p);
        const size_t begin = chunk * c.grain;
        (*c.f)(begin, std::min(c.n, begin + c.grain));
      },
      &context);
}

/// f(chunk) for every chunk in [0, chunks).
template <class F>
void parallel_chunks(Task& task, size_t chunks, F&& f) {
  task.pool().run(
      task, chunks,
      [](void* p, size_t chunk) { (*static_cast<std::remove_reference_t<F>*>(p))(chunk); }, &f);
}

/// Sum of map(begin, end) over fixed chunks, added up in chunk order: the same bits for any number of threads.
/// T needs operator+=.
template <class T, class F>
T parallel_reduce(Task& task, size_t n, size_t grain, T zero, F&& map) {
  grain = std::max<size_t>(1, grain);
  std::vector<T> parts((n + grain - 1) / grain, zero);
  parallel_for(task, n, grain,
               [&](size_t begin, size_t end) { parts[begin / grain] = map(begin, end); });
  T sum = zero;
  for (const T& part : parts) sum += part;
  return sum;
}

}  // namespace jalon
