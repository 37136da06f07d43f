// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"

#include <doctest/doctest.h>

#include <string>

using namespace jalon;

TEST_CASE("fail__throws_the_status_and_the_formatted_line") {
  try {
    fail(Status::kNotFound, "field \"%s\", point %d of %llu", "label", -3, 18446744073709551615ull);
    FAIL("fail came back");
  } catch (const Error& error) {
    CHECK(error.status() == Status::kNotFound);
    CHECK(std::string(error.what()) == "field \"label\", point -3 of 18446744073709551615");
  }
}

TEST_CASE("fail__cuts_a_long_text_instead_of_overrunning") {
  const std::string name(5000, 'x');
  try {
    fail(Status::kIo, "file %s", name.c_str());
    FAIL("fail came back");
  } catch (const std::exception& error) {
    const std::string text = error.what();
    CHECK(text.size() >= 500);
    CHECK(text.size() < name.size());
    CHECK(("file " + name).starts_with(text));
  }
}
