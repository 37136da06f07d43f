// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The frame of every page: the times against their sum, the parameters against another JSON reader.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "base/error.h"
#include "report/pages/html_frame.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using page_scenes::tables_of;

namespace {

std::string parameters_page(std::string_view json) {
  Page page;
  add_parameters(page, json);
  return page.html().take();
}

}  // namespace

TEST_CASE("html_frame__times_end_with_their_sum") {
  Notes notes;
  notes.times_s = {{"read", 0.25}, {"segment <all>", 1.5}, {"write", 0.0014}};
  Page page;
  add_times(page, notes);
  const std::string html = page.html().take();
  const auto table = tables_of(html, "Times").at(0);
  REQUIRE(table.size() == 4);
  CHECK(table[0] == page_scenes::Row{"read", "0.250 s"});
  CHECK(table[1] == page_scenes::Row{"segment &lt;all&gt;", "1.500 s"});
  CHECK(table[3] == page_scenes::Row{"together", "1.751 s"});
  notes.times_s.clear();
  add_times(page, notes);
  CHECK(page.html().take().empty());
}

TEST_CASE("html_frame__parameters_read_as_they_were_written") {
  const std::string json =
      R"({"tolerance_m": 0.02, "method": "icp", "robust": false, "radii": [0.5, 1, 2.25], "n": 7})";
  const auto truth = nlohmann::json::parse(json);
  const auto table = tables_of(parameters_page(json), "Parameters").at(0);
  REQUIRE(table.size() == truth.size());
  for (const auto& row : table) {
    REQUIRE(row.size() == 2);
    REQUIRE(truth.contains(row[0]));
    if (truth[row[0]].is_string()) CHECK(row[1] == truth[row[0]].get<std::string>());  // no quotes
    else CHECK(nlohmann::json::parse(row[1]) == truth[row[0]]);
  }
  CHECK(table[0][0] == "tolerance_m");  // in their order
  CHECK(table[4][0] == "n");
  CHECK(parameters_page("").empty());
  CHECK(parameters_page("{}").empty());
  try {
    parameters_page("{\"a\": }");
    CHECK(false);
  } catch (const Error& error) {
    CHECK(error.status() == Status::kInvalidArgument);
  }
}

TEST_CASE("html_frame__head_is_one_whole_document_that_loads_nothing") {
  Page page;
  open_page(page, "</title><script>");
  page.note("body");
  const std::string html = page.html().take();
  CHECK(markup::well_formed(html));
  CHECK(html.rfind("<!DOCTYPE html>", 0) == 0);
  const auto tags = markup::tags(html);
  REQUIRE(tags.size() > 5);
  CHECK(tags[0].name == "html");
  CHECK(tags[0].attribute("lang") == "en");
  CHECK(tags.back().name == "/html");
  bool has_charset = false, has_policy = false, is_after_body = false;
  for (const auto& tag : tags) {
    has_charset |= tag.attribute("charset") == "utf-8";
    has_policy |= tag.attribute("http-equiv") == "Content-Security-Policy" && !is_after_body &&
                  tag.attribute("content").starts_with("default-src &#39;none&#39;");
    is_after_body |= tag.name == "body";
    if (tag.name == "p") CHECK(is_after_body);
    for (const char* loading : {"script", "link", "img", "iframe"}) CHECK(tag.name != loading);
    if (tag.name == "title") CHECK(tag.text_after == "&lt;/title&gt;&lt;script&gt;");
  }
  CHECK(has_charset);
  CHECK(has_policy);
}
