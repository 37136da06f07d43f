// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/deflate_blocks.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "unit/formats/files/inflated.h"

using namespace jalon;

namespace {

std::string packed(const std::string& bytes, unsigned threads = 1) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return zlib_blocks(bytes, task);
}

void check_back(const std::string& bytes) {
  const Inflated back(packed(bytes));
  CHECK(back.ok);
  CHECK(back.text == bytes);
}

/// Bytes about zero, as differences of neighbours are.
std::string differences(size_t n, uint64_t seed) {
  RandomStream random(seed, 3);
  std::string out(n, '\0');
  for (char& c : out) c = static_cast<char>(static_cast<int>(4 * random.normal()));
  return out;
}

}  // namespace

TEST_CASE("deflate_blocks__what_was_packed_comes_back_whatever_it_is") {
  check_back("");
  check_back("a");
  check_back("aaaaaaaa");
  check_back(std::string(200000, '\0'));
  for (const size_t run : {3, 4, 5, 10, 11, 18, 19, 34, 66, 130, 257, 258, 259, 260, 262, 517})
    check_back("b" + std::string(run, 'x') + "c");
  check_back(differences(300000, 1));
  std::string all;
  for (int i = 0; i < 5000; ++i) all += static_cast<char>(i * 7 % 256);
  check_back(all);
}

TEST_CASE("deflate_blocks__takes_little_more_than_the_entropy_and_the_same_for_any_threads") {
  const std::string bytes = differences(400000, 2);
  const std::string one = packed(bytes);
  // A normal distribution of sigma 4, cut to whole numbers toward zero: about 3.9 bits a byte.
  const double bits = 8 * static_cast<double>(one.size()) / static_cast<double>(bytes.size());
  CHECK(bits < 4.1);
  CHECK(bits > 3.5);
  CHECK(one == packed(bytes, 2));
  CHECK(one == packed(bytes, 5));
  CHECK(packed(std::string(1000000, '\0')).size() < 3000);
}
