// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/dxf/group_reader.h"

#include <doctest/doctest.h>

#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::dxf;
using namespace jalon::test;

namespace {

template <class F>
void with_groups(const std::string& bytes, F&& use) {
  const Folder folder;
  spill(folder.file("a.dxf"), bytes);
  const ByteSource source(folder.file("a.dxf"));
  GroupReader groups(source);
  use(groups);
}

}  // namespace

TEST_CASE("dxf_groups__come_in_pairs_of_lines_with_blanks_around_them") {
  with_groups("  0\r\nSECTION\r\n 10\n   1.5 \n1070\n 7\n", [](GroupReader& groups) {
    REQUIRE(groups.next());
    CHECK(groups.is(0, "SECTION"));
    groups.put_back();
    REQUIRE(groups.next());
    CHECK(groups.is(0, "SECTION"));
    REQUIRE(groups.next());
    CHECK(groups.number() == 1.5);
    REQUIRE(groups.next());
    CHECK(groups.integer() == 7);
    CHECK_FALSE(groups.next());
  });
}

TEST_CASE("dxf_groups__texts_have_their_characters_and_what_is_no_text_is_replaced") {
  with_groups("1\nt\\U+00E9t\\U+20AC\n1\n\\U+00\n1\n\\U+ZZZZ\xff\n", [](GroupReader& groups) {
    REQUIRE(groups.next());
    CHECK(groups.text() == "t\xC3\xA9t\xE2\x82\xAC");
    REQUIRE(groups.next());
    CHECK(groups.text() == "\\U+00");
    REQUIRE(groups.next());
    CHECK(groups.text() == "\\U+ZZZZ\xEF\xBF\xBD");
  });
}

TEST_CASE("dxf_groups__what_is_wrong_is_named_with_its_line") {
  const auto refusal = [](const std::string& bytes, auto&& use) {
    Failure failure;
    with_groups(bytes, [&](GroupReader& groups) { failure = failure_of([&] { use(groups); }); });
    CHECK(failure.status == Status::kFormat);
    return failure.text;
  };
  const auto all = [](GroupReader& groups) {
    while (groups.next()) {
    }
  };
  CHECK(has_text(refusal("0\nSECTION\nx\n", all), "line 3: \"x\" is no group code"));
  CHECK(has_text(refusal("0\nSECTION\n10\n", all),
                 "line 3: the file ends before the value of group 10"));
  const auto number = [](GroupReader& groups) {
    REQUIRE(groups.next());
    return groups.number();
  };
  CHECK(has_text(refusal("10\n1e999\n", number), "line 2: group 10: \"1e999\" is no number"));
  CHECK(has_text(refusal("10\nnan\n", number), "is no number"));
}
