// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/output_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "cli/handles.h"

namespace jalon::cli {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, const std::error_code& error) {
  throw Failure{JALON_ERROR_IO, path.string() + ": " + error.message()};
}

constexpr int kPrivateFolders = 1000;  // runs at once into one folder

/// Takes the lock of a folder for as long as the descriptor is open, however the process ends. -1:
/// another run holds it; of an old folder also where the file system knows no locks, and nobody can
/// tell.
int locked(const fs::path& folder, bool is_new) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  if (is_new && errno != EWOULDBLOCK) return descriptor;
  close(descriptor);
  return -1;
}

}  // namespace

OutputFolder::OutputFolder(const std::string& folder) : folder_(folder) {
  std::error_code error;
  created_ = fs::create_directories(folder_, error);
  if (error || !fs::is_directory(folder_))
    refuse(folder_, error ? error : std::make_error_code(std::errc::not_a_directory));
  for (int i = 0; i < kPrivateFolders && lock_ < 0; ++i) {
    private_ = folder_ / (".jalon-" + std::to_string(i));
    const bool is_new = fs::create_directory(private_, error);
    if (error) refuse(private_, error);
    lock_ = locked(private_, is_new);
    if (lock_ < 0 || is_new) continue;
    // Nobody held it: a run that was killed left it with what it had written.
    for (const auto& entry : fs::directory_iterator(private_, error))
      fs::remove_all(entry.path(), error);
  }
  if (lock_ < 0) refuse(private_, std::make_error_code(std::errc::device_or_resource_busy));
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(private_, ignored);
  if (lock_ >= 0) close(lock_);
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
