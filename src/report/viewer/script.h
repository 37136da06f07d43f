// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jalon {

// viewer.js as it stands in the page, and its SHA-256, which lets a browser run this script and no other. CMake makes
// the source file of them (script.cmake).
extern const char kViewerScript[];
extern const char kViewerScriptSha256[];  ///< 64 hexadecimal digits

}  // namespace jalon
