// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <string>
#include <type_traits>
#include <vector>

#include "base/field.h"
#include "base/parallel.h"
#include "formats/files/atomic_file.h"

namespace jalon {

/// The shortest text that reads back to the same number of this type.
template <class T>
void append_number(std::string& out, T value) {
  char text[40];
  std::to_chars_result result{};
  if constexpr (sizeof(T) == 1)
    result = std::to_chars(text, text + sizeof text, static_cast<int>(value));
  else result = std::to_chars(text, text + sizeof text, value);
  out.append(text, result.ptr);
}

/// The components of one item, each after a separator.
inline void append_item(std::string& out, const Column& column, size_t item, char separator) {
  const uint32_t components = column.info().components;
  visit(column.info().type, [&](auto zero) {
    using T = decltype(zero);
    const T* from = static_cast<const T*>(column.raw()) + item * components;
    for (uint32_t c = 0; c < components; ++c) {
      out += separator;
      append_number(out, from[c]);
    }
  });
}

/// append(begin, end, text) for [0, n), in parallel over chunks of grain items; the texts go to the
/// file in order.
template <class F>
void write_in_batches(size_t n, size_t batch, size_t grain, AtomicFile& file, Task& task,
                      F&& append) {
  std::vector<std::string> texts((std::min(batch, n) + grain - 1) / grain);
  for (size_t first = 0; first < n; first += batch) {
    const size_t count = std::min(batch, n - first);
    ProgressSpan span(task, static_cast<double>(first) / static_cast<double>(n),
                      static_cast<double>(first + count) / static_cast<double>(n));
    parallel_for(task, count, grain, [&](size_t begin, size_t end) {
      std::string& text = texts[begin / grain];
      text.clear();
      append(first + begin, first + end, text);
    });
    for (size_t t = 0; t * grain < count; ++t) file.write(texts[t]);
  }
}

}  // namespace jalon
