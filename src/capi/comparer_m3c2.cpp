// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/comparison_handles.h"
#include "capi/support/methods.h"
#include "formats/files/byte_source.h"
#include "jalon/comparer.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

std::string text_of_file(const char* path) {
  constexpr uint64_t kMostBytes = 1 << 20;  // such files have some forty lines
  const ByteSource source(path);
  if (source.size() > kMostBytes)
    fail(Status::kFormat, "%.200s is too large for an M3C2 parameter file", path);
  std::string text(static_cast<size_t>(source.size()), '\0');
  source.read(0, text.data(), text.size());
  return text;
}

}  // namespace

jalon_status jalon_comparer_read_m3c2_file(jalon_comparer* comparer, const char* path,
                                           jalon_task* task) {
  return guard([&] {
    require(comparer, "comparer");
    require_text(path, "path");
    const auto read = require_run(compare_methods(), *comparer->method, &CompareMethod::read_file,
                                  "has no such file");
    with_task(task, [&](Task& t) {
      for (const std::string& line : read(text_of_file(path), *comparer->values))
        t.log(Task::kWarning, "%s", line.c_str());
    });
  });
}
