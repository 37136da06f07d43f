// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/target_catalogue.h"

#include <doctest/doctest.h>

#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("target_catalogue__reads_kinds_sizes_and_codes") {
  const TargetCatalogue read = target_catalogue_from_json(
      R"({"size_sigma_m": 0.002, "targets": [
        {"code": 4, "kind": "disc", "size_m": 0.06, "name": "gutter"},
        {"code": "350.2", "kind": "checker", "size_m": 0.2}]})");
  REQUIRE(read.entries.size() == 2);
  CHECK(read.size_sigma_m == 0.002);
  CHECK(read.entries[0].code == "4");
  CHECK(read.entries[0].name == "gutter");
  CHECK(read.entries[0].kind == TargetKind::kDisc);
  CHECK(read.entries[1].code == "350.2");
  CHECK(read.entries[1].size_m == 0.2);
}

TEST_CASE("target_catalogue__refuses_what_no_target_has") {
  const auto status = [](const char* text) {
    return status_of([&] { (void)target_catalogue_from_json(text); });
  };
  CHECK(status("{") == Status::kInvalidArgument);
  for (const char* wrong :
       {"[]", "{}", R"({"targets": []})", R"({"targets": [1]})",
        R"({"targets": [{"kind": "checker", "size_m": 0.1}]})",
        R"({"targets": [{"code": "1;2", "kind": "checker", "size_m": 0.1}]})",
        R"({"targets": [{"code": "1", "kind": "sphere", "size_m": 0.1}]})",
        R"({"targets": [{"code": "1", "kind": "checker"}]})",
        R"({"targets": [{"code": "1", "kind": "checker", "size_m": -0.1}]})",
        R"({"size_sigma_m": "big", "targets": [{"code": "1", "kind": "disc", "size_m": 0.1}]})"})
    CHECK_MESSAGE(status(wrong) == Status::kFormat, std::string(wrong));
}
