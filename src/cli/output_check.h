// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jalon::cli {

// What could not be written after the work is told before it. Another process may still change that meanwhile: the
// writing looks again.

/// A folder for results: nothing of this name or a folder, and no file on the way there.
void check_output_folder(const std::string& path);
/// A file: no folder of this name, and a folder to hold it.
void check_output_file(const std::string& path);
/// A file of a cloud or a model (content "cloud", "model"): also an extension of a format that can be written.
void check_output_file(const std::string& path, const char* content);

/// Extensions of the formats that can be written with this content, each with a blank before and behind: " las  ply ".
std::string written_extensions(const char* content);

}  // namespace jalon::cli
