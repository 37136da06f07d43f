// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What fuzzing found, read again by any build: replay FOLDER, with a folder for each target that holds its inputs. A
// crash of any is the end of the program and a failure.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "fuzz_targets.h"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  int passed = 0, failed = 0;
  for (size_t i = 0; fuzz::target(i) != nullptr; ++i) {
    const fuzz::Target& target = *fuzz::target(i);
    const auto folder = std::filesystem::path(arguments[1]) / target.name;
    std::vector<std::filesystem::path> inputs;
    if (std::filesystem::is_directory(folder))
      for (const auto& entry : std::filesystem::directory_iterator(folder))
        inputs.push_back(entry.path());
    if (inputs.empty()) {
      std::printf("not ok - %s: no input\n", target.name);
      ++failed;
      continue;
    }
    std::sort(inputs.begin(), inputs.end());
    for (const auto& path : inputs) {
      std::ifstream in(path, std::ios::binary);
      const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
      std::printf("%s\n", path.filename().c_str());  // the last line names what it was
      std::fflush(stdout);
      target.read(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
    }
    std::printf("ok - %s: %zu inputs\n", target.name, inputs.size());
    ++passed;
  }
  std::printf("%d passed, %d failed\n", passed, failed);
  return failed == 0 ? 0 : 1;
}
