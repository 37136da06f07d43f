// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/html_frame.h"

#include "base/json_reader.h"
#include "base/json_writer.h"
#include "base/text_number.h"
#include "report/pages/html_model.h"
#include "report/viewer/view_page.h"

namespace jalon {

namespace {

// Dark on white, one column, prints without surprises. No scripts, fonts or pictures from elsewhere.
constexpr const char* kStyle =
    "body{font-family:Helvetica,Arial,sans-serif;color:#1a1a1a;background:#fff;max-width:64rem;"
    "margin:2rem auto;"
    "padding:0 1rem;"
    "line-height:1.4}"
    "h1{font-size:1.7rem;margin:0 0 .3rem}h2{font-size:1.15rem;margin:2rem 0 "
    ".5rem;border-bottom:1px solid #bbb;"
    "padding-bottom:.2rem}"
    ".lead{font-size:1.05rem;color:#333}"
    ".scroll{overflow-x:auto;margin:0 0 1rem}"
    "table{border-collapse:collapse;font-size:.88rem}th,td{padding:.22rem "
    ".6rem;text-align:left;vertical-align:top;"
    "border-bottom:1px solid #e2e2e2}"
    "thead th{border-bottom:2px solid #777;white-space:nowrap}"
    ".n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}"
    "td bdi{overflow-wrap:anywhere}"
    "svg{width:100%;height:auto;max-height:60rem}"
    ".note{color:#555;font-size:.85rem}"
    "@media print{body{margin:0;max-width:none}h2{break-after:avoid}tr,svg{break-inside:avoid}}";

}  // namespace

void open_page(Page& page, std::string_view title) {
  auto& html = page.html();
  html.raw("<!DOCTYPE html>\n");
  html.open("html", {{"lang", "en"}}).open("head");
  html.leaf("meta", {{"charset", "utf-8"}});
  html.leaf("meta", {{"http-equiv", "Content-Security-Policy"}, {"content", content_policy()}});
  html.leaf("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  html.element("title", {}, title);
  html.open("style").raw(kStyle).raw(viewer_style()).close();
  html.close().open("body");
}

void add_times(Page& page, const Notes& notes) {
  if (notes.times_s.empty()) return;
  page.heading("Times");
  auto& html = page.html();
  html.open("table").open("tbody");
  double sum = 0;
  const auto row = [&](const std::string& name, double seconds) {
    html.open("tr");
    page.foreign("th", name);
    page.number(text_of(seconds, 3) + " s");
    html.close();
  };
  for (const auto& [name, seconds] : notes.times_s) {
    row(name, seconds);
    sum += seconds;
  }
  row("together", sum);
  html.close().close();
}

void add_parameters(Page& page, std::string_view json) {
  if (json.empty()) return;
  std::vector<std::pair<std::string, std::string>> pairs;
  const std::vector<JsonValue> parameters = read_json(json);
  for (const JsonValue& value : JsonChildren(parameters[0]))
    pairs.emplace_back(value.name, value.kind == JsonValue::Kind::kText
                                       ? value.text
                                       : JsonWriter().value(value).take());
  if (pairs.empty()) return;
  page.heading("Parameters");
  add_pairs(page, pairs);
}

}  // namespace jalon
