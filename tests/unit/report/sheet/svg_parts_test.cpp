// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Parts of drawings read back by another reader, texts cut to every width.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "report/sheet/svg_parts.h"
#include "unit/report/drawn.h"

using namespace jalon;

TEST_CASE("svg_parts__grouped_digits_are_the_number_in_threes") {
  CHECK(grouped(0) == "0");
  CHECK(grouped(999) == "999");
  CHECK(grouped(1000) == "1 000");
  CHECK(grouped(~uint64_t{0}) == "18 446 744 073 709 551 615");
  RandomStream random(1, 0);
  for (int i = 0; i < 200; ++i) {
    const uint64_t n = random.bits() >> random.below(64);
    const std::string text = grouped(n);
    for (size_t k = 0; k < text.size(); ++k)
      CHECK((text[text.size() - 1 - k] == ' ') == (k % 4 == 3));
    std::string digits = text;
    std::erase(digits, ' ');
    CHECK(digits == std::to_string(n));
  }
}

TEST_CASE("svg_parts__fitted_text_is_the_longest_beginning_that_fits_in_whole_characters") {
  const std::vector<std::string> characters{
      "a", "W", " ", "\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x8F\xA0"};
  RandomStream random(2, 0);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<std::string> text(random.below(20));
    std::string whole;
    for (std::string& c : text) whole += c = characters[random.below(characters.size())];
    // 6 mm a character of 10 mm; half a character keeps the widths off the borders.
    const double size = 10;
    CHECK(text_width(whole, size) == doctest::Approx(6 * static_cast<double>(text.size())));
    const size_t room = 4 + random.below(20);
    const std::string fitted = fitted_text(whole, size, 6 * (static_cast<double>(room) + 0.5));
    std::string wanted = whole;
    if (text.size() > room) {
      wanted.clear();
      for (size_t i = 0; i < room - 3; ++i) wanted += text[i];
      wanted += "...";
    }
    CHECK(fitted == wanted);
  }
  CHECK(fitted_text("abcdef", 10, 1) == "...");
  const std::string broken = fitted_text(std::string(50, '\xFF'), 10, 60.5);
  CHECK(broken == std::string(7, '\xFF') + "...");
}

TEST_CASE("svg_parts__paths_read_back_as_their_corners") {
  RandomStream random(3, 0);
  std::vector<std::vector<Vec2>> rings(4);
  std::vector<Vec2> all;
  for (size_t k = 0; k < rings.size(); ++k)
    for (size_t i = 0; i < 3 + k; ++i) {
      rings[k].push_back({400 * random.uniform() - 200, 400 * random.uniform() - 200});
      all.push_back(rings[k].back());
    }
  const auto check = [](const std::vector<Vec2>& read, const std::vector<Vec2>& meant) {
    REQUIRE(read.size() == meant.size());
    for (size_t i = 0; i < read.size(); ++i) {
      CHECK(std::fabs(read[i].u - meant[i].u) <= drawn::kRounding_mm);
      CHECK(std::fabs(read[i].v - meant[i].v) <= drawn::kRounding_mm);
    }
  };
  const std::string closed = svg_rings(rings), open = svg_polyline(rings[3]);
  check(drawn::corners(closed), all);
  check(drawn::corners(open), rings[3]);
  CHECK(std::count(closed.begin(), closed.end(), 'M') == 4);
  CHECK(std::count(closed.begin(), closed.end(), 'Z') == 4);
  CHECK(std::count(open.begin(), open.end(), 'M') == 1);
  CHECK(open.find('Z') == std::string::npos);
  CHECK(svg_polyline({}).empty());
}

TEST_CASE("svg_parts__texts_are_escaped_and_turned_about_their_own_place") {
  const std::string svg = drawn::svg_of([](SvgWriter& out) {
    svg_text(out, {12, 34.5}, 3, Anchor::kEnd, "a <b> & \"c\"", true, true);
    svg_text(out, {1, 2}, 3, Anchor::kStart, "level");
  });
  CHECK(markup::well_formed(svg));
  const auto texts = drawn::elements(svg, "text");
  REQUIRE(texts.size() == 2);
  CHECK(texts[0].text_after == "a &lt;b&gt; &amp; &quot;c&quot;");
  CHECK(texts[0].attribute("transform") == "rotate(-90 12 34.5)");
  CHECK(texts[0].attribute("text-anchor") == "end");
  CHECK(texts[0].attribute("font-weight") == "bold");
  CHECK(texts[1].attribute("font-weight") == "normal");
  // An upright text that ends at its place begins below it.
  const auto boxes = markup::text_boxes(svg);
  CHECK(boxes[0].top == doctest::Approx(34.5));
  CHECK(boxes[0].bottom > 34.5);
  CHECK(boxes[1].left == 1);
}
