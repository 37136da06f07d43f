// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/data_set.h"

#include <cerrno>
#include <new>

#include "base/error.h"
#include "formats/files/system_error.h"
#include "formats/files/utf8.h"

namespace jalon::ept {

namespace fs = std::filesystem;

namespace {

constexpr int kDataSetTries = 1000;  // writers of one data set at once
constexpr const char* kLockFile = "lock";

fs::path path_of(const std::string& utf8) { return {std::u8string(utf8.begin(), utf8.end())}; }

std::string text_of_path(const fs::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
}

[[noreturn]] void refuse(const fs::path& path, const char* action, const std::string& cause) {
  fail(Status::kIo, "%s: cannot %s: %s", text_of_path(path).c_str(), action, cause.c_str());
}

}  // namespace

DataSet::DataSet(const std::string& index) {
  const fs::path path = path_of(index);
  if (lower(text_of_path(path.filename())) != kIndexFile)
    fail(
        Status::kInvalidArgument,
        "%s: an EPT data set is a folder, and is named by the file ept.json in it: folder/ept.json",
        index.c_str());
  index_path_ = path_of(resolved_path(index));
  folder_ = index_path_.has_parent_path() ? index_path_.parent_path() : fs::path(".");
  std::error_code error;
  made_folder_ = fs::create_directory(folder_, error);
  if (error) refuse(folder_, "make the folder", error.message());
  try {
    index_.emplace(text_of_path(index_path_));
    take_private_folder();
    make_folder(private_ / kDataFolder);
    make_folder(private_ / kHierarchyFolder);
  } catch (...) {
    undo();
    throw;
  }
}

DataSet::~DataSet() { undo(); }

// Those that nobody holds a lock in are what killed writers left.
void DataSet::take_private_folder() {
  std::error_code error;
  for (int i = 0; i < kDataSetTries; ++i) {
    fs::path path = folder_ / (".jalon-ept-" + std::to_string(i));
    fs::create_directory(path, error);
    if (error) refuse(path, "make the folder", error.message());
    const std::string lock = text_of_path(path / kLockFile);
    remove_unlocked(lock);
    lock_ = create_locked(lock);
    if (lock_ == kNoFile && errno == EEXIST) continue;
    if (lock_ == kNoFile) {
      const std::string cause = system_error_text(errno);
      fs::remove(path, error);  // not where another writer has its lock in it
      refuse(path, "write", cause);
    }
    private_.swap(path);
    for (const fs::directory_entry& left : fs::directory_iterator(private_, error))
      if (left.path().filename() != kLockFile) fs::remove_all(left.path(), error);
    return;
  }
  refuse(folder_, "write", "too many others write there");
}

void DataSet::make_folder(const Path& path) {
  std::error_code error;
  fs::create_directory(path, error);
  if (error) refuse(path, "make the folder", error.message());
}

void DataSet::write(const char* folder, const std::string& name, const void* data,
                    size_t bytes) const {
  AtomicFile file(text_of_path(private_ / folder / name));
  file.write(data, bytes);
  file.commit();
}

void DataSet::move(const Path& from, const Path& to) {
  std::error_code error;
  moved_.emplace_back(from, to);
  fs::rename(from, to, error);
  if (!error) return;
  moved_.pop_back();
  refuse(from, "move", error.message());
}

void DataSet::move_away(const Path& old, const char* to) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(old, ignored))) move(old, private_ / to);
}

// In between there is no index, so that nobody takes the files of two data sets for one.
void DataSet::commit(std::string_view index) {
  index_->write(index);
  move_away(index_path_, "old-index");
  move_away(folder_ / kDataFolder, "old-data");
  move_away(folder_ / kHierarchyFolder, "old-hierarchy");
  for (const char* name : {kDataFolder, kHierarchyFolder}) move(private_ / name, folder_ / name);
  index_->commit();
  moved_.clear();
  made_folder_ = false;
}

void DataSet::undo() noexcept {
  std::error_code ignored;
  for (; !moved_.empty(); moved_.pop_back())
    fs::rename(moved_.back().second, moved_.back().first, ignored);
  index_.reset();
  if (lock_ != kNoFile) close_file(std::exchange(lock_, kNoFile));
  try {
    if (!private_.empty()) fs::remove_all(private_, ignored);
  } catch (const std::bad_alloc&) {  // the next writer takes away what is left
  }
  if (made_folder_) fs::remove(folder_, ignored);  // only where it is empty
}

}  // namespace jalon::ept
