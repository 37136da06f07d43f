// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/output_folder.h"

#include <unistd.h>

#include "cli/handles.h"

namespace jalon::cli {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, const std::error_code& error) {
  throw Failure{JALON_ERROR_IO, path.string() + ": " + error.message()};
}

}  // namespace

OutputFolder::OutputFolder(const std::string& folder) : folder_(folder) {
  std::error_code error;
  created_ = fs::create_directories(folder_, error);
  if (error || !fs::is_directory(folder_))
    refuse(folder_, error ? error : std::make_error_code(std::errc::not_a_directory));
  private_ = folder_ / (".jalon-" + std::to_string(getpid()));
  fs::create_directory(private_, error);
  if (error) refuse(private_, error);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(private_, ignored);
  if (created_) fs::remove(folder_, ignored);  // only when still empty
}

std::string OutputFolder::path(const std::string& name) {
  names_.push_back(name);
  return (private_ / name).string();
}

void OutputFolder::commit() {
  std::error_code error;
  for (const auto& name : names_) {
    fs::rename(private_ / name, folder_ / name, error);
    if (error) refuse(folder_ / name, error);
  }
}

}  // namespace jalon::cli
