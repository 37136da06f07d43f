// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jalon::capi {

bool is_png(const std::string& path);
/// The caller's notes, at most 1 MiB; "" for NULL.
std::string notes_text(const char* notes_json);
/// Replaces the file when the text is whole on the disk.
void write_whole(const std::string& path, const std::string& text);

}  // namespace jalon::capi
