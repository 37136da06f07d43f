// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/envelope.h"

#include <doctest/doctest.h>

#include <cstring>
#include <string>
#include <vector>

#include "base/error.h"

namespace jalon {
namespace {

std::vector<uint8_t> sealed_payload(size_t bytes, BytesKind kind, Task& task) {
  std::vector<uint8_t> whole(kHeaderBytes + bytes, 0x5a);
  write_header(whole, kind, task);
  return whole;
}

Status refusal(const std::vector<uint8_t>& whole, BytesKind kind, std::string* message = nullptr) {
  Task task;
  try {
    payload_of(whole, kind, task);
  } catch (const Error& error) {
    if (message != nullptr) *message = error.what();
    return error.status();
  }
  return Status::kOk;
}

TEST_CASE("envelope__is_the_header_that_is_promised_for_ever") {
  Task task;
  const auto whole = sealed_payload(3, BytesKind::kModel, task);
  const uint8_t expected[24] = {0x89, 'J', 'L', 'N', 0x0d, 0x0a, 0x1a, 0x0a, 1, 0, 0, 0,
                                3,    0,   0,   0,   3,    0,    0,    0,    0, 0, 0, 0};
  CHECK(std::memcmp(whole.data(), expected, sizeof expected) == 0);
  CHECK(std::memcmp(whole.data() + 28, "\0\0\0\0ZZZ", 7) == 0);
  const auto payload = payload_of(whole, BytesKind::kModel, task);
  CHECK(payload.data() == whole.data() + kHeaderBytes);
  CHECK(payload.size() == 3);
}

TEST_CASE("envelope__sums_payloads_of_several_mib_alike_for_any_threads") {
  std::vector<std::vector<uint8_t>> made;
  for (const unsigned threads : {1u, 3u}) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    made.push_back(sealed_payload((size_t{3} << 20) + 5, BytesKind::kCloud, task));
  }
  CHECK(made[0] == made[1]);
  made[0].back() ^= 0x80;
  CHECK(refusal(made[0], BytesKind::kCloud) == Status::kFormat);
}

TEST_CASE("envelope__tells_what_is_wrong") {
  Task task;
  std::string message;
  auto whole = sealed_payload(8, BytesKind::kCloud, task);
  CHECK(refusal(whole, BytesKind::kScanner, &message) == Status::kInvalidArgument);
  CHECK(message == "these are the bytes of a cloud, not of a scanner");
  whole.resize(20);
  CHECK(refusal(whole, BytesKind::kCloud) == Status::kFormat);
  whole = sealed_payload(8, BytesKind::kCloud, task);
  whole.push_back(0);
  CHECK(refusal(whole, BytesKind::kCloud, &message) == Status::kFormat);
  CHECK(message == "the bytes of a cloud are cut or too many: 9 behind the header, not 8");
  whole = sealed_payload(8, static_cast<BytesKind>(99), task);
  CHECK(refusal(whole, BytesKind::kCloud, &message) == Status::kInvalidArgument);
  CHECK(message.find("a kind that this release does not know") != std::string::npos);
  whole = sealed_payload(0, BytesKind::kCloud, task);
  CHECK(refusal(whole, BytesKind::kCloud) == Status::kOk);
}

}  // namespace
}  // namespace jalon
