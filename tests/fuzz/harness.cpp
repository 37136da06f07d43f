// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "harness.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <unistd.h>

namespace fuzz {

bool succeeds(jalon_status status) {
  if (status == JALON_OK) return true;
  const std::string line = jalon_last_error_message();
  if (line.empty() || line.find('\n') != std::string::npos || status == JALON_ERROR_INTERNAL) {
    std::fprintf(stderr, "status %d: %s\n", status, line.c_str());
    std::abort();
  }
  return false;
}

void must(jalon_status status) {
  if (!succeeds(status)) {
    std::fprintf(stderr, "status %d: %s\n", status, jalon_last_error_message());
    std::abort();
  }
}

std::string place_of(const std::string& extension) {
  static const std::string stem =
      (::access("/dev/shm", W_OK) == 0 ? "/dev/shm/jalon_fuzz_" : "/tmp/jalon_fuzz_") +
      std::to_string(::getpid());
  return stem + "." + extension;
}

std::string file_with(const std::string& extension, const void* data, size_t size) {
  const std::string path = place_of(extension);
  FILE* const out = std::fopen(path.c_str(), "wb");
  if (out == nullptr || std::fwrite(data, 1, size, out) != size) std::abort();
  std::fclose(out);
  return path;
}

jalon_task* one_thread() {
  static jalon_task* task = nullptr;
  if (task == nullptr) {
    must(jalon_task_create(&task));
    must(jalon_task_set_threads(task, 1));
  }
  return task;
}

std::string take_text(const uint8_t*& data, size_t& size, char end) {
  const uint8_t* const last = std::find(data, data + size, static_cast<uint8_t>(end));
  std::string out(data, last);
  const size_t taken = std::min(size, out.size() + 1);
  data += taken;
  size -= taken;
  return out;
}

}  // namespace fuzz
