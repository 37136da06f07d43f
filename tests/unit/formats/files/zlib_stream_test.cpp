// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/zlib_stream.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "unit/formats/files/inflated.h"

using namespace jalon;

namespace {

std::string packed(const std::string& bytes, Redundancy redundancy, unsigned threads = 1) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return zlib_stream(bytes, redundancy, task);
}

void check_back(const std::string& bytes) {
  for (const Redundancy redundancy : {Redundancy::kAny, Redundancy::kRuns}) {
    const Inflated back(packed(bytes, redundancy));
    CHECK(back.ok);
    CHECK(back.text == bytes);
  }
}

/// Bytes about zero, as differences of neighbours are.
std::string differences(size_t n, uint64_t seed) {
  RandomStream random(seed, 3);
  std::string out(n, '\0');
  for (char& c : out) c = static_cast<char>(static_cast<int>(4 * random.normal()));
  return out;
}

}  // namespace

TEST_CASE("zlib_stream__what_was_packed_comes_back_whatever_it_is") {
  check_back("");
  check_back("a");
  check_back(std::string(200000, '\0'));
  for (const size_t n : {131071, 131072, 131073, 262144, 300000}) check_back(differences(n, 1));
  std::string all;
  for (int i = 0; i < 5000; ++i) all += static_cast<char>(i * 7 % 256);
  check_back(all);
  RandomStream random(2, 1);
  std::string noise(150000, '\0');
  for (char& c : noise) c = static_cast<char>(random.below(256));
  check_back(noise);
  CHECK(packed(noise, Redundancy::kAny).size() < 150200);  // stored where nothing is saved
}

TEST_CASE("zlib_stream__takes_little_more_than_the_entropy_and_the_same_for_any_threads") {
  const std::string bytes = differences(400000, 2);
  const std::string one = packed(bytes, Redundancy::kRuns);
  // A normal distribution of sigma 4, cut to whole numbers toward zero: about 3.9 bits a byte.
  const double bits = 8 * static_cast<double>(one.size()) / static_cast<double>(bytes.size());
  CHECK(bits < 4.1);
  CHECK(bits > 3.5);
  for (const unsigned threads : {2u, 5u}) {
    CHECK(one == packed(bytes, Redundancy::kRuns, threads));
    CHECK(packed(bytes, Redundancy::kAny) == packed(bytes, Redundancy::kAny, threads));
  }
  CHECK(packed(std::string(1000000, '\0'), Redundancy::kRuns).size() < 3000);
}

TEST_CASE("zlib_stream__rows_that_repeat_are_found_where_anything_is_looked_for") {
  const std::string row = differences(3000, 4);
  std::string rows;
  for (int i = 0; i < 20; ++i) rows += row;
  CHECK(5 * packed(rows, Redundancy::kAny).size() < packed(rows, Redundancy::kRuns).size());
}
