// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/output_folder.h"

#include "cli/handles.h"

namespace jalon::cli {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, const std::error_code& error) {
  throw Failure{JALON_ERROR_IO, path.string() + ": " + error.message()};
}

constexpr int kPrivateFolders = 1000;  // runs at once into one folder

}  // namespace

OutputFolder::OutputFolder(const std::string& folder) : folder_(folder) {
  std::error_code error;
  created_ = fs::create_directories(folder_, error);
  if (error || !fs::is_directory(folder_))
    refuse(folder_, error ? error : std::make_error_code(std::errc::not_a_directory));
  bool is_locked = false;
  for (int i = 0; i < kPrivateFolders && !is_locked; ++i) {
    private_ = folder_ / (".jalon-" + std::to_string(i));
    const bool is_new = fs::create_directory(private_, error);
    if (error) refuse(private_, error);
    is_locked = lock_.take(private_, is_new);
    if (!is_locked || is_new) continue;
    // Nobody held it: a run that was killed left it with what it had written.
    for (const auto& entry : fs::directory_iterator(private_, error))
      fs::remove_all(entry.path(), error);
  }
  if (!is_locked) refuse(private_, std::make_error_code(std::errc::device_or_resource_busy));
}

OutputFolder::~OutputFolder() {
  lock_.remove_and_release();
  std::error_code ignored;
  if (created_) fs::remove(folder_, ignored);  // only when still empty
}

std::string OutputFolder::path(const std::string& name) {
  names_.push_back(name);
  return unlisted_path(name);
}

std::string OutputFolder::unlisted_path(const std::string& name) const {
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
