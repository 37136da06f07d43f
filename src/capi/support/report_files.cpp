// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/report_files.h"

#include <algorithm>

#include "capi/support/guard.h"
#include "formats/files/atomic_file.h"

namespace jalon::capi {

namespace {

constexpr size_t kMaxNotesBytes = size_t{1} << 20;

}  // namespace

bool is_png(const std::string& path) {
  const auto lower = [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  };
  const std::string end = path.size() >= 4 ? path.substr(path.size() - 4) : "";
  return end.size() == 4 &&
         std::equal(end.begin(), end.end(), ".png", [&](char a, char b) { return lower(a) == b; });
}

std::string notes_text(const char* notes_json) {
  return notes_json != nullptr ? require_text(notes_json, "notes_json", kMaxNotesBytes)
                               : std::string();
}

void write_whole(const std::string& path, const std::string& text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace jalon::capi
