// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "formats/png/grey_file.h"
#include "formats/png/png.h"
#include "unit/formats/opened_file.h"

namespace jalon::test {

/// A grey file of 2 x 2 pixels: 0, 1; 2, 3.
inline std::string small_png(const char* keyword = "none", const std::string& text = "-") {
  Task task;
  const png::GreyImage image{2, 2, 8, {0, 1, 2, 3}};
  return png::grey_png(image, keyword, text, task);
}

inline Failure refusal_of_png(const std::string& bytes, const ReadSettings& settings = {}) {
  const OpenedFile file(bytes, "a.png");
  Task task;
  return failure_of([&] { read_png(file, settings, task); });
}

}  // namespace jalon::test
