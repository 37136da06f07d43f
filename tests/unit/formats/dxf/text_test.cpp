// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Groups of DXF against the rules of the DXF Reference: numbers read back, texts stay in their line.
#include "formats/dxf/text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/random.h"
#include "base/text_number.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using dxf::Version;

namespace {

/// The value that a text becomes in a group.
std::string line_of(std::string_view text, Version version) {
  dxf::Text out(version);
  out.group(1, text);
  const std::string group = out.take();
  CHECK(group.substr(0, 4) == "  1\n");
  CHECK(group.find('\n', 4) == group.size() - 1);
  return group.substr(4, group.size() - 5);
}

}  // namespace

TEST_CASE("dxf_text__numbers_read_back_the_same_and_look_like_numbers_with_a_point") {
  RandomStream random(1, 1);
  for (int i = 0; i < 1000; ++i) {
    const double value = i % 3 == 0 ? static_cast<double>(random.below(1000000))
                                    : random.normal() * std::pow(10.0, i % 40 - 20);
    dxf::Text out(Version::kR12);
    out.group(40, value);
    const std::string text = out.take(), line = text.substr(4, text.size() - 5);
    double back = NAN;
    REQUIRE(parse_number(line, back));
    CHECK(back == value);
    CHECK(line.find_first_of(".e") != std::string::npos);
  }
  dxf::Text out(Version::kR2000);
  out.group(0, "X").group(70, -5).group(1071, 7).point(11, {1, -2.5, 1e300}).handle(5, 0xABC0DEF9);
  CHECK(out.size() > 0);
  CHECK(out.take() ==
        "  0\nX\n 70\n-5\n1071\n7\n 11\n1.0\n 21\n-2.5\n 31\n1e+300\n  5\nABC0DEF9\n");
  CHECK(out.size() == 0);
}

TEST_CASE("dxf_text__what_is_no_finite_number_is_refused_by_its_group") {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const double value : {kInf, -kInf, std::nan("")}) {
    dxf::Text out(Version::kR2000);
    const test::Failure failure = test::failure_of([&] { out.group(42, value); });
    CHECK(failure.status == Status::kUnsupported);
    CHECK(failure.text.find("group 42") != std::string::npos);
    CHECK(out.size() == 0);
    CHECK(test::failure_of([&] {
            out.point(10, {1, 2, value});
          }).text.find("group 30") != std::string::npos);
  }
  dxf::Text out(Version::kR2000);
  CHECK(out.group(42, std::numeric_limits<double>::max()).take() ==
        " 42\n1.7976931348623157e+308\n");
}

TEST_CASE("dxf_text__handles_owners_and_markers_are_of_release_2000") {
  for (const Version version : {Version::kR12, Version::kR2000}) {
    dxf::Text out(version);
    CHECK(out.is_r12() == (version == Version::kR12));
    out.begin("LAYER", 0x1F, 2, 105).subclass("AcDbEntity").group(8, "0");
    CHECK(out.take() == (out.is_r12() ? "  0\nLAYER\n  8\n0\n"
                                      : "  0\nLAYER\n105\n1F\n330\n2\n100\nAcDbEntity\n  8\n0\n"));
  }
}

TEST_CASE("dxf_text__other_characters_are_told_by_their_code_or_give_way") {
  const std::string cafe = "caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80 ~";
  CHECK(line_of(cafe, Version::kR2000) == "caf\\U+00E9 \\U+20AC _ ~");  // U+E9, U+20AC, U+1F600
  CHECK(line_of(cafe, Version::kR12) == "caf_ _ _ ~");
  CHECK(line_of("\xFF", Version::kR2000) == "\\U+FFFD");
  CHECK(line_of("", Version::kR2000).empty());
  for (int c = 1; c < 128; c = c == 31 ? 127 : c + 1)
    CHECK(line_of(std::string("a") + static_cast<char>(c) + "b", Version::kR2000) == "a b");
}

TEST_CASE("dxf_text__a_line_has_255_bytes_at_most_and_no_half_character") {
  CHECK(line_of(std::string(300, 'x'), Version::kR12) == std::string(255, 'x'));
  for (size_t n = 240; n < 260; ++n) {
    const std::string line = line_of(std::string(n, 'x') + "\xC3\xA9", Version::kR2000);
    CHECK(line == std::string(std::min<size_t>(n, 255), 'x') + (n + 7 <= 255 ? "\\U+00E9" : ""));
  }
}
