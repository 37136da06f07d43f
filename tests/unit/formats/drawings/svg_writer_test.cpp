// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Text of drawings against a reader of tags written here, and numbers against what they were.
#include "formats/drawings/svg_writer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

/// The names of the elements in the order of their ends; "broken" where tags do not match.
std::string closed_in_order(const std::string& xml) {
  std::vector<std::string> open;
  std::string out;
  for (size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const size_t end = xml.find('>', at);
    if (end == std::string::npos) return "broken";
    const bool is_end = xml[at + 1] == '/', is_leaf = xml[end - 1] == '/';
    const size_t first = at + (is_end ? 2 : 1);
    const std::string name = xml.substr(first, xml.find_first_of(" />", first) - first);
    if (is_end && (open.empty() || open.back() != name)) return "broken";
    if (is_end) open.pop_back();
    if (is_end || is_leaf) out += name;
    else open.push_back(name);
  }
  return open.empty() ? out : "broken";
}

std::string unescaped(const std::string& xml) {
  constexpr std::pair<const char*, char> kReferences[] = {
      {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&#39;", '\''}};
  std::string out;
  for (size_t at = 0; at < xml.size();) {
    size_t taken = 0;
    for (const auto& [reference, meaning] : kReferences)
      if (xml.compare(at, std::string_view(reference).size(), reference) == 0) {
        taken = std::string_view(reference).size();
        out += meaning;
      }
    if (taken == 0) out += xml[at];
    at += std::max<size_t>(taken, 1);
  }
  return out;
}

}  // namespace

TEST_CASE("svg_writer__tags_match_whatever_was_opened_and_what_was_left_open_is_closed") {
  RandomStream random(1, 1);
  const char* kElements[] = {"a", "bc", "g", "text"};
  for (int round = 0; round < 50; ++round) {
    SvgWriter svg;
    std::vector<std::string> open;
    std::string wanted;
    for (int step = 0; step < 60; ++step) {
      const std::string name = kElements[random.below(4)];
      switch (random.below(4)) {
        case 0:
          svg.open(name, {{"n", step}, {"x", 0.5}});
          open.push_back(name);
          break;
        case 1:
          svg.leaf(name, {{"hostile", "<g a='\">"}});
          wanted += name;
          break;
        case 2:
          svg.element(name, {}, "</g><a/>").text("</svg>");
          wanted += name;
          break;
        default:
          svg.close();  // nothing to close is no error
          if (!open.empty()) wanted += open.back();
          if (!open.empty()) open.pop_back();
      }
      CHECK(svg.depth() == open.size());
    }
    for (; !open.empty(); open.pop_back()) wanted += open.back();
    CHECK(closed_in_order(svg.take()) == wanted);
    CHECK(svg.depth() == 0);
    CHECK(svg.take().empty());
  }
}

TEST_CASE("svg_writer__escaped_text_reads_back_and_holds_no_markup") {
  std::string plain = "a\tb\nc\rd \xC3\xA9 \xF0\x9F\x98\x80 \xEF\xBF\xBC";
  for (char c = 0x20; c < 0x7F; ++c) plain += c;
  const std::string safe = xml_escaped(plain + "&amp;");
  CHECK(safe.find_first_of("<>\"'") == std::string::npos);
  CHECK(unescaped(safe) == plain + "&amp;");
  SvgWriter svg;
  svg.leaf("a", {{"t", plain}});
  CHECK(unescaped(svg.take()) == "<a t=\"" + plain + "\"/>\n");
  svg.raw("<!-- own -->");
  CHECK(svg.take() == "<!-- own -->");
}

TEST_CASE("svg_writer__what_xml_does_not_know_becomes_the_replacement_character") {
  const std::string replacement = "\xEF\xBF\xBD";
  std::vector<std::string> none{"\x7F", "\xFF", "\xEF\xBF\xBE", "\xEF\xBF\xBF"};
  for (char c = 0; c < 0x20; ++c)
    if (c != '\t' && c != '\n' && c != '\r') none.push_back(std::string(1, c));
  for (const std::string& bytes : none) {
    CHECK(xml_escaped(bytes) == replacement);
    CHECK(xml_escaped("x" + bytes + bytes + "y") == "x" + replacement + replacement + "y");
  }
}

TEST_CASE("svg_writer__numbers_are_right_to_half_a_unit_of_their_last_place_and_no_longer") {
  RandomStream random(2, 1);
  for (int i = 0; i < 2000; ++i) {
    const int decimals = static_cast<int>(random.below(5));
    const double size = std::pow(10.0, static_cast<double>(random.below(9)) - 4),
                 value = size * random.normal(), unit = std::pow(10.0, -decimals);
    const std::string text = svg_number(value, decimals);
    CAPTURE(text);
    double back = NAN;
    REQUIRE(parse_number(text, back));
    CHECK(std::fabs(back - value) <= unit / 2 * (1 + 1e-9) + 1e-15 * std::fabs(value));
    const size_t point = text.find('.');
    CHECK((point == std::string::npos || (text.back() != '0' && text.back() != '.')));
    CHECK((point == std::string::npos || text.size() - point - 1 <= static_cast<size_t>(decimals)));
    CHECK(text != "-0");
  }
  CHECK(svg_number(1200) == "1200");  // zeros before the point stay
  for (const double none : {NAN, INFINITY, -INFINITY}) CHECK(svg_number(none) == "0");
  double huge = 0;
  CHECK(parse_number(svg_number(-1e300), huge));
  CHECK(huge == -1e300);
}
