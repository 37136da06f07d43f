// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/system/folder_lock.h"

#include <windows.h>

namespace jalon::cli {

namespace {

// A file in the folder that nobody else can open; it goes with its handle. Windows shares folders too freely.
constexpr const wchar_t* kLockFile = L"lock";

}  // namespace

bool FolderLock::take(const std::filesystem::path& folder, bool) {
  const HANDLE handle =
      ::CreateFileW((folder / kLockFile).c_str(), GENERIC_WRITE, 0, nullptr, OPEN_ALWAYS,
                    FILE_ATTRIBUTE_HIDDEN | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return false;
  folder_ = folder;
  handle_ = reinterpret_cast<std::intptr_t>(handle);
  return true;
}

void FolderLock::remove_and_release() {
  if (handle_ == -1) return;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored))
    if (entry.path().filename() != kLockFile) std::filesystem::remove_all(entry.path(), ignored);
  release();
  // Empty now, unless another run has taken it meanwhile: then it holds that run's lock and stays.
  ::RemoveDirectoryW(folder_.c_str());
}

void FolderLock::release() {
  if (handle_ != -1) ::CloseHandle(reinterpret_cast<HANDLE>(handle_));
  handle_ = -1;
}

}  // namespace jalon::cli
