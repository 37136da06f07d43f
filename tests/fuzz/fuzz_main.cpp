// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// One program of libFuzzer for all targets: JALON_FUZZ_TARGET names the one.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "fuzz_targets.h"

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t room);

namespace {

const fuzz::Target* chosen() {
  static const fuzz::Target* const target = [] {
    const char* const name = std::getenv("JALON_FUZZ_TARGET");
    return name == nullptr ? nullptr : fuzz::find_target(name);
  }();
  return target;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (chosen() != nullptr) return 0;
  std::fprintf(stderr, "JALON_FUZZ_TARGET names none of");
  for (size_t i = 0; fuzz::target(i) != nullptr; ++i)
    std::fprintf(stderr, " %s", fuzz::target(i)->name);
  std::fprintf(stderr, "\n");
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  chosen()->read(data, size);
  return 0;
}

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t room, unsigned) {
  const size_t changed = LLVMFuzzerMutate(data, size, room);
  if (chosen()->mend == nullptr) return changed;
  std::string bytes(reinterpret_cast<const char*>(data), changed);
  chosen()->mend(bytes);
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(data));
  return changed;
}
