// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "base/error.h"
#include "report/charts/residual_chart.h"
#include "report/names/notes.h"
#include "report/report.h"
#include "unit/modelling/walls.h"
#include "unit/report/markup.h"

using namespace walls;

namespace {

// A wall of 10 x 4 m with a window of 1.2 x 1.5 m, and a plane 0.2 m behind the window.
Segmentation small_facade() {
  WallScan wall, pane;
  wall.azimuth = pane.azimuth = 0;
  wall.width = 10;
  wall.height = 4;
  wall.spacing = pane.spacing = 0.04;
  const Rectangle window{2, 1, 3.2, 2.5};
  wall.solid = [=](double u, double v) { return !window.contains(u, v); };
  pane.width = 10;
  pane.height = 4;
  pane.solid = [=](double u, double v) { return window.contains(u, v); };
  pane.shift = {0, 1, 0};
  auto behind = pane.points();
  for (Vec3& p : behind) p.y -= 0.8;
  return segmentation_of({wall.points(), behind});
}

std::string elevation_of(const Segmentation& s, const Model& m, const char* json = "{}") {
  ParamSet options("elevation", elevation_rows());
  options.from_json(json);
  Task task;
  return elevation_svg(s, m, settings_from<ElevationSettings>(options), task);
}

std::string html_of(const Segmentation& s, const Model& m, std::string_view notes,
                    unsigned threads = 1) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return report_html(s, m, notes, {}, task);
}

std::string json_of(const Segmentation& s, const Model& m, std::string_view notes) {
  Task task;
  return report_json(s, m, notes, task);
}

}  // namespace

TEST_CASE("elevation: millimetres on paper follow the scale") {
  const Segmentation s = small_facade();
  const Model m = outlines_of(s);
  for (const int scale : {20, 50, 100}) {
    const std::string json =
        "{\"paper\": \"A3\", \"labels\": false, \"scale\": " + std::to_string(scale) + "}";
    const std::string svg = elevation_of(s, m, json.c_str());
    CAPTURE(scale);
    const auto tags = markup::tags(svg);
    REQUIRE(tags.size() > 10);
    // The page is measured in millimetres: width="420mm" and viewBox "0 0 420 297".
    const std::string box = tags[0].attribute("viewBox");
    CHECK(box.substr(4, box.find(' ', 4) - 4) + "mm" == tags[0].attribute("width"));
    // The first face drawn is the one behind; the last filled path is the wall. Its outline is 10 m wide.
    double low = INFINITY, high = -INFINITY;
    for (const auto& tag : tags)
      if (tag.name == "path" && tag.attribute("class") == "face")
        for (const double x : markup::path_x(tag.attribute("d"))) {
          low = std::min(low, x);
          high = std::max(high, x);
        }
    CHECK((high - low) * scale / 1000 == doctest::Approx(10).epsilon(0.01).scale(0));
  }
}

TEST_CASE("elevation: picks a usual scale and paper, well-formed, axes and scale bar in metres") {
  const Segmentation s = small_facade();
  const std::string svg = elevation_of(s, outlines_of(s));
  CHECK(markup::well_formed(svg));
  for (const char* text : {"Distance along the facade (m)", "Height Z (m)", "1:50",
                           "Depth from main plane (m)", "+0.20", "Facade elevation"})
    CHECK_MESSAGE(svg.find(text) != std::string::npos, text);
}

TEST_CASE("elevation: texts do not overlap") {
  const Segmentation s = small_facade();
  const std::string svg = elevation_of(s, outlines_of(s));
  const auto boxes = markup::text_boxes(svg);
  REQUIRE(boxes.size() > 20);
  for (size_t i = 0; i < boxes.size(); ++i)
    for (size_t j = i + 1; j < boxes.size(); ++j)
      CHECK_MESSAGE(!boxes[i].meets(boxes[j]), boxes[i].text << " | " << boxes[j].text);
}

TEST_CASE("elevation: nothing to draw is a drawing that says so") {
  const Segmentation empty = segmentation_of({});
  const std::string svg = elevation_of(empty, Model{});
  CHECK(markup::well_formed(svg));
  CHECK(svg.find("no planes to draw") != std::string::npos);
  CHECK(markup::well_formed(html_of(empty, Model{}, "")));
  CHECK(nlohmann::json::parse(json_of(empty, Model{}, ""))["planes"].empty());
}

TEST_CASE("elevation: a national grid and heights are shown true") {
  WallScan wall;
  wall.azimuth = 0;
  wall.spacing = 0.05;
  wall.shift = {652000, 6861000, 137};
  const Segmentation s = segmentation_of({wall.points()});
  const std::string svg = elevation_of(s, outlines_of(s));
  CHECK(svg.find(">140.0<") != std::string::npos);   // a height on the axis
  CHECK(svg.find("652000.0") != std::string::npos);  // the corner in the title block
}

TEST_CASE("report_html: self-contained, with all its chapters") {
  const Segmentation s = small_facade();
  const std::string html =
      html_of(s, outlines_of(s),
              R"({"title": "North wall", "input": {"file": "a.las"}, "times": {"read": 0.25}})");
  CHECK(markup::well_formed(html));
  for (const char* text :
       {"North wall", "a.las", "0.250 s", "Planes", "Residuals", "Parameters", "distance_tolerance",
        "Elevation", "Labelled points", "In three dimensions"})
    CHECK_MESSAGE(html.find(text) != std::string::npos, text);
  // Its scripts are data and the one program that its policy names.
  for (const auto& tag : markup::tags(html))
    if (tag.name == "script") CHECK(tag.attribute("src").empty());
  CHECK(html.find("default-src &#39;none&#39;") != std::string::npos);
  for (const char* text : {"<link", " src=", "@import", "url(http"})
    CHECK_MESSAGE(html.find(text) == std::string::npos, text);
  for (size_t at = html.find("href="); at != std::string::npos; at = html.find("href=", at + 1))
    CHECK(html.compare(at, 11, "href=\"data:") == 0);  // pictures are in the page itself
}

TEST_CASE("report_html: without points of the viewer there is no script") {
  const Segmentation s = small_facade();
  Task task;
  const std::string html = report_html(s, outlines_of(s), "", {.viewer_points = 0}, task);
  CHECK(markup::well_formed(html));
  CHECK(html.find("<script") == std::string::npos);
  CHECK(html.size() < html_of(s, outlines_of(s), "").size());
}

TEST_CASE("report_html: the same bits for any number of threads") {
  const Segmentation s = small_facade();
  const Model m = outlines_of(s);
  const std::string one = html_of(s, m, "", 1);
  CHECK(one == html_of(s, m, "", 2));
  CHECK(one == html_of(s, m, "", 7));
}

TEST_CASE("report_json: the planes and residuals as numbers") {
  const Segmentation s = small_facade();
  const auto json =
      nlohmann::json::parse(json_of(s, outlines_of(s), R"({"input": {"file": "a.las"}})"));
  REQUIRE(json["planes"].size() == 2);
  CHECK(json["planes"][0]["inliers"] == s.segments[0].fit.n);
  CHECK(json["faces"][0]["openings"] == 1);
  CHECK(json["input"]["file"] == "a.las");
  CHECK(json["points"] == s.cloud->size());
  uint64_t sum =
      json["residuals"]["below"].get<uint64_t>() + json["residuals"]["above"].get<uint64_t>();
  for (const auto& n : json["residuals"]["bins"]) sum += n.get<uint64_t>();
  CHECK(sum == s.cloud->size());
  CHECK(json["residuals"]["sigma_m"].get<double>() ==
        doctest::Approx(0.004).epsilon(0.05).scale(0));
}

TEST_CASE("reports: spheres and cylinders have a table of their own") {
  Segmentation s = small_facade();
  CHECK(html_of(s, Model{}, "").find("Spheres and cylinders") == std::string::npos);
  Segment ball, column;
  ball.label = 3;
  ball.type = PrimitiveType::kSphere;
  ball.sphere = {{{1, 2, 3}, 0.9125}, 400, 0.003, {}};
  ball.sphere.covariance[15] = 1e-8;
  column.label = 4;
  column.type = PrimitiveType::kCylinder;
  column.cylinder.cylinder = {{4, 5, 6}, {0, 0, 1}, 0.2525};
  column.length_u_m = 3.25;
  s.segments.push_back(ball);
  s.segments.push_back(column);
  const std::string html = html_of(s, Model{}, "");
  CHECK(markup::well_formed(html));
  for (const char* text : {"2 planes and 2 spheres and cylinders", "Spheres and cylinders",
                           "0.9125", ">0.10<", "0.2525", "3.25"})
    CHECK_MESSAGE(html.find(text) != std::string::npos, text);
  const auto json = nlohmann::json::parse(json_of(s, Model{}, ""));
  CHECK(json["planes"].size() == 2);
  REQUIRE(json["spheres"].size() == 1);
  REQUIRE(json["cylinders"].size() == 1);
  CHECK(json["spheres"][0]["radius_m"] == 0.9125);
  CHECK(json["spheres"][0]["centre"][2] == 3.0);
  CHECK(json["spheres"][0]["sigma_radius_m"] == doctest::Approx(1e-4).scale(0));
  CHECK(json["cylinders"][0]["axis"][2] == 1.0);
  CHECK(json["cylinders"][0]["length_m"] == 3.25);
}

TEST_CASE("reports: hostile names never alter structure") {
  const std::vector<std::string> names{"<script>alert(1)</script>",
                                       "</title><script>",
                                       "\"><img src=x onerror=alert(1)>",
                                       "'><svg/onload=alert(1)>",
                                       "<!--",
                                       "-->",
                                       "<![CDATA[",
                                       "]]>",
                                       "&lt;script&gt;",
                                       "&#60;b&#62;",
                                       "&amp",
                                       "&",
                                       "<",
                                       ">",
                                       "\"",
                                       "'",
                                       "`",
                                       "</style>",
                                       "</svg>",
                                       "</text></svg><script>",
                                       "<?xml version=\"1.0\"?>",
                                       "<!DOCTYPE x [<!ENTITY e \"v\">]>",
                                       "&e;",
                                       "javascript:alert(1)",
                                       "=cmd|' /C calc'!A0",
                                       "+1+1",
                                       "-2",
                                       "@SUM(A1)",
                                       "../../etc/passwd",
                                       "C:\\nul",
                                       "a/b\\c",
                                       "line\nbreak",
                                       "tab\there",
                                       "carriage\rreturn",
                                       std::string("nul\0byte", 8),
                                       "\x01\x02\x1b[31m",
                                       "\x7f",
                                       "\xff\xfe",
                                       "\xc0\xaf",
                                       "\xed\xa0\x80",
                                       "\xef\xbf\xbe",
                                       "\xe2\x80\xae"
                                       "gnp.exe",
                                       "\xe2\x80\xa8",
                                       "%s%n%x",
                                       "${jndi:ldap://x}",
                                       "{{7*7}}",
                                       "<a href=javascript:alert(1)>",
                                       "</bdi>",
                                       "\\u003cscript\\u003e",
                                       std::string(5000, 'A'),
                                       std::string(2000, '<'),
                                       "]]></title>",
                                       ""};
  REQUIRE(names.size() >= 40);
  Segmentation s = small_facade();
  const Model m = outlines_of(s);
  const auto with = [&](const std::string& name, std::string& svg, std::string& html,
                        std::string& json) {
    const auto dumped = [](const nlohmann::ordered_json& j) {
      return j.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    };
    nlohmann::ordered_json notes, parameters;
    notes["title"] = name;
    notes["input"] = {{"file", name}};
    notes["input"]["k" + name] = "value";
    notes["times"] = {{"t" + name, 1.0}};
    parameters["p" + name] = name;
    Segmentation named = s;
    named.parameters_json = dumped(parameters);
    Cloud cloud = *s.cloud;
    cloud.crs = "crs" + name;
    named.cloud = std::make_shared<Cloud>(cloud);
    ElevationSettings settings;
    settings.title = name;
    Task task;
    svg = elevation_svg(named, m, settings, task);
    html = html_of(named, m, dumped(notes));
    json = json_of(named, m, dumped(notes));
  };
  std::string plain_svg, plain_html, plain_json;
  with("plain", plain_svg, plain_html, plain_json);
  const auto svg_shape = markup::shape(plain_svg), html_shape = markup::shape(plain_html);
  REQUIRE(html_shape.size() > 100);
  for (const auto& name : names) {
    std::string svg, html, json;
    with(name, svg, html, json);
    CAPTURE(name);
    CHECK(markup::shape(svg) == svg_shape);
    CHECK(markup::shape(html) == html_shape);
    CHECK(markup::well_formed(svg));
    CHECK(markup::well_formed(html));
    CHECK(markup::has_only_xml_characters(svg));
    CHECK(markup::has_only_xml_characters(html));
    const auto parsed = nlohmann::json::parse(json, nullptr, false);
    REQUIRE(parsed.is_object());
    CHECK(parsed.size() == nlohmann::json::parse(plain_json).size());
  }
}

TEST_CASE("read_notes: malformed notes are refused with a reason") {
  for (const char* text : {"{", "[]", "1", "null", "\"x\"", "{\"title\": 3}", "{\"input\": []}",
                           "{\"input\": {\"a\": []}}", "{\"times\": {\"a\": \"b\"}}",
                           "{\"times\": 1}", "{\"title\": \"a\"} x", "\xff"}) {
    CAPTURE(text);
    try {
      read_notes(text);
      CHECK(false);
    } catch (const Error& error) {
      CHECK(error.status() == Status::kInvalidArgument);
    }
  }
  const std::string deep(200000, '[');
  CHECK_THROWS_AS(read_notes(deep), Error);
  const Notes notes =
      read_notes(R"({"title": "T", "input": {"b": 1, "a": true}, "times": {"x": 2}, "more": []})");
  CHECK(notes.title == "T");
  REQUIRE(notes.input.size() == 2);
  CHECK(notes.input[0].first == "b");
  CHECK(notes.input[1].second == "yes");
  CHECK(notes.times_s[0].second == 2);
}

TEST_CASE("bin_residuals: every finite residual is counted once") {
  Segmentation s = small_facade();
  auto residuals = std::make_shared<Column>(s.residuals->info(), s.cloud->size());
  const auto values = residuals->values<float>();
  for (size_t i = 0; i < values.size(); ++i)
    values[i] = i % 3 == 0 ? NAN : 0.001f * static_cast<float>(i % 7) - 0.003f;
  s.residuals = residuals;
  Task task;
  const Residuals r = bin_residuals(s, 0, 40, task);
  uint64_t sum = r.below + r.above;
  for (const uint64_t n : r.bins) sum += n;
  CHECK(sum == r.count);
  CHECK(r.count == values.size() - (values.size() + 2) / 3);
  CHECK(r.sigma_m == doctest::Approx(0.002).epsilon(0.01).scale(0));
  for (size_t i = 0; i < values.size(); ++i) values[i] = 0;
  const Residuals zero = bin_residuals(s, 0, 40, task);
  CHECK(zero.sigma_m == 0);
  CHECK(markup::well_formed(residual_chart(zero)));
}
