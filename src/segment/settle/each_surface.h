// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/parallel.h"
#include "segment/ransac/extraction.h"

namespace jalon {

/// f(s) for every surface s: large ones one after the other with all threads inside f, small ones side by side, which
/// are most of them and would each wait for its threads. f works on its own surface alone.
template <class F>
void for_each_surface(const std::vector<Surface>& surfaces, Task& task, F&& f) {
  constexpr size_t kLarge = 1 << 16;  // points: about a millisecond of work
  const auto is_large = [&](size_t s) { return surfaces[s].positions.size() >= kLarge; };
  for (size_t s = 0; s < surfaces.size(); ++s)
    if (is_large(s)) f(s);
  parallel_for(task, surfaces.size(), 1, [&](size_t s, size_t) {
    if (!is_large(s)) f(s);
  });
}

}  // namespace jalon
