// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>

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

/// Sorts on this thread, with looks for a cancel: runs that take some milliseconds, merged two by two. less: an order
/// in which no two elements are equal but those that nothing tells apart, or what comes of it hangs on the runs.
template <class Iterator, class Less = std::less<>>
void serial_sort(Task& task, Iterator first, Iterator last, Less less = {}) {
  constexpr size_t kRun = size_t{1} << 15;
  constexpr size_t kComparisonsPerLook = size_t{1} << 18;  // some milliseconds
  const auto n = static_cast<size_t>(std::distance(first, last));
  const auto at = [&](size_t i) {
    return first + static_cast<std::iter_difference_t<Iterator>>(std::min(i, n));
  };
  serial_for(task, n, kRun, [&](size_t begin, size_t end) { std::sort(at(begin), at(end), less); });
  size_t compared = 0;  // the last of the merges may take tenths of a second
  const auto looking_less = [&](const auto& a, const auto& b) {
    if (++compared % kComparisonsPerLook == 0) task.checkpoint(0);
    return less(a, b);
  };
  for (size_t run = kRun; run < n; run *= 2)
    serial_for(task, n, 2 * run, [&](size_t begin, size_t end) {
      std::inplace_merge(at(begin), at(begin + run), at(end), looking_less);
    });
}

}  // namespace jalon
