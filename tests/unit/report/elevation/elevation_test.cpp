// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "base/error.h"
#include "report/report.h"
#include "unit/modelling/walls.h"
#include "unit/report/markup.h"
#include "unit/report/named_facade.h"

using namespace jalon;

namespace {

std::string drawing_of(const Model& model, const char* json = "{}") {
  validate(model);
  ParamSet set("elevation", elevation_rows());
  set.from_json(json);
  Task task;
  return elevation_svg(walls::segmentation_of({}), model, settings_from<ElevationSettings>(set),
                       task);
}

bool has_text(const std::string& svg, const std::string& text) {
  for (const auto& tag : markup::tags(svg))
    if (tag.name == "text" && tag.text_after == text) return true;
  return false;
}

size_t count_texts(const std::string& svg, const std::string& text) {
  size_t n = 0;
  for (const auto& tag : markup::tags(svg)) n += tag.name == "text" && tag.text_after == text;
  return n;
}

std::vector<markup::Tag> paths(const std::string& svg, const char* class_name) {
  std::vector<markup::Tag> out;
  for (const auto& tag : markup::tags(svg))
    if (tag.name == "path" && tag.attribute("class") == class_name) out.push_back(tag);
  return out;
}

// The part of the page that a wrong placement would leave: every text lies on the paper.
void check_layout(const std::string& svg) {
  CHECK(markup::well_formed(svg));
  const std::string box = markup::tags(svg)[0].attribute("viewBox");
  const size_t second = box.find(' ', 4);
  const double width = markup::number(box.substr(4, second - 4)),
               height = markup::number(box.substr(second + 1));
  const auto boxes = markup::text_boxes(svg);
  for (size_t i = 0; i < boxes.size(); ++i) {
    const auto& b = boxes[i];
    CHECK_MESSAGE((b.left >= 0 && b.top >= 0 && b.right <= width && b.bottom <= height), b.text);
    for (size_t j = i + 1; j < boxes.size(); ++j)
      CHECK_MESSAGE(!b.meets(boxes[j]), b.text << " | " << boxes[j].text);
  }
}

}  // namespace

TEST_CASE(
    "elevation: dimensions of columns, axes, ground floor, sills and heads, and levels above the "
    "ground") {
  named_facade::Setting s;
  s.shift = {652000, 6861000, 137};
  const std::string svg = drawing_of(named_facade::make(s));
  check_layout(svg);
  CHECK(count_texts(svg, "15.00") == 1);  // the walls, without the ends of the cornice
  CHECK(count_texts(svg, "3.00") == 4);   // from axis to axis
  CHECK(count_texts(svg, "1.00") == 1);   // the door, below
  CHECK(count_texts(svg, "0.95") == 1);
  CHECK(has_text(svg,
                 "\xC2\xB1"
                 "0.00"));
  CHECK(has_text(svg, "+2.40"));
  CHECK(has_text(svg, "+10.60"));
  CHECK(has_text(svg,
                 "\xC2\xB1"
                 "0.00 = Z 137.00"));
  CHECK(has_text(svg, "652000.000, 6861000.000, 137.000"));
}

TEST_CASE("elevation: arcs are arcs of the true radius, with the crown up") {
  named_facade::Setting s;
  const std::string svg = drawing_of(named_facade::make(s), R"({"paper": "A3", "scale": 100})");
  size_t arched = 0;
  for (const auto& tag : paths(svg, "opening")) {
    const std::string d = tag.attribute("d");
    const size_t at = d.find('A');
    if (at == std::string::npos) continue;
    ++arched;
    // "Arx ry rotation large sweep x y": 0.6 m at 1:100, clockwise on the page from the left spring to the right.
    CHECK(d.substr(at, 4) == "A6 6");
    CHECK(d.substr(at).find(" 0 1 ") != std::string::npos);
  }
  CHECK(arched == 5);
}

TEST_CASE("elevation: a circle in a plane turned away from the eye is an ellipse") {
  named_facade::Setting s;
  s.rows = 1;
  s.door = s.no_data = false;
  Model m = named_facade::make(s);
  const double angle = 0.2;  // below the front angle
  for (Vec3& p : m.vertices)
    p = {p.x * std::cos(angle) - p.y * std::sin(angle),
         p.x * std::sin(angle) + p.y * std::cos(angle), p.z};
  for (Face& f : m.faces) {
    const Vec3 n = f.plane.normal;
    f.plane.normal = {n.x * std::cos(angle) - n.y * std::sin(angle),
                      n.x * std::sin(angle) + n.y * std::cos(angle), n.z};
  }
  const std::string svg = drawing_of(m, R"({"paper": "A3", "scale": 100})");
  const std::string d = paths(svg, "opening").front().attribute("d");
  const size_t at = d.find('A');
  REQUIRE(at != std::string::npos);
  const double flat = markup::number(d.substr(at + 1, d.find(' ', at) - at - 1));
  CHECK(flat == doctest::Approx(6 * std::cos(angle)).epsilon(1e-3).scale(0));
}

TEST_CASE("elevation: windows, doors, copies, empty openings and missing data can be told apart") {
  named_facade::Setting s;
  s.copied = 3;
  s.empty = 5;
  const std::string svg = drawing_of(named_facade::make(s));
  check_layout(svg);
  const auto openings = paths(svg, "opening");
  REQUIRE(openings.size() == 15);
  std::set<std::string> colours;
  size_t dashed = 0;
  for (const auto& tag : openings) {
    colours.insert(tag.attribute("stroke"));
    dashed += tag.attribute("stroke-dasharray") != "none";
  }
  CHECK(colours.size() == 2);
  CHECK(dashed == 1);
  for (const char* text :
       {"window", "door", "copied: not measured here", "nothing seen in it", "no data", "ground",
        "1.20 x 1.50", "1.20 x 2.10 arch", "1.00 x 2.30", "-0.30", "+0.15 (13)", "+0.25"})
    CHECK_MESSAGE(has_text(svg, text), text);
  for (const char* absent : {"plane seen at an angle", "plane seen edge-on", "other opening"})
    CHECK(!has_text(svg, absent));
  CHECK(count_texts(svg, "W1") == 10);  // nine windows and the legend
  CHECK(svg.find("url(#unknown)") != std::string::npos);
}

TEST_CASE("elevation: a hole that no part fills and nothing stands behind is hatched") {
  named_facade::Setting s;
  s.no_data = false;
  s.empty = 5;
  Model m = named_facade::make(s);
  CHECK(drawing_of(m).find("url(#unknown)") == std::string::npos);
  m.rings[m.faces[0].first_ring + 6].part = kNoPart;
  CHECK(drawing_of(m).find("url(#unknown)") != std::string::npos);
}

TEST_CASE("elevation: more than a hundred openings stay legible at every scale") {
  named_facade::Setting s;
  s.columns = 16;
  s.rows = 8;
  const Model m = named_facade::make(s);
  for (const char* json : {"{}", R"({"scale": 500})", R"({"scale": 1000})", R"({"paper": "A4"})",
                           R"({"outlines_only": true})"}) {
    CAPTURE(json);
    check_layout(drawing_of(m, json));
  }
  CHECK(has_text(drawing_of(m), "111"));  // windows of the first type in the table
}

TEST_CASE("elevation: a tower stands on upright paper, at a larger scale than landscape holds") {
  named_facade::Setting s;
  s.columns = 3;
  s.rows = 9;
  const std::string svg = drawing_of(named_facade::make(s));
  check_layout(svg);
  CHECK(has_text(svg, "1:100  (A3 upright)"));
  CHECK(markup::tags(svg)[0].attribute("width") == "297mm");
  CHECK(has_text(drawing_of(named_facade::make(s), R"({"paper": "A4"})"), "1:500  (A4)"));
}

TEST_CASE("elevation: colours by side, by depth or none") {
  const Model m = named_facade::make({});
  const auto fills = [&](const char* json) {
    std::set<std::string> out;
    for (const auto& tag : paths(drawing_of(m, json), "face")) out.insert(tag.attribute("fill"));
    return out;
  };
  const auto sides = fills(R"({"colours": "sides"})");
  CHECK(sides.size() == 5);  // in front, main plane, two depths behind, hatching
  for (const std::string& fill : sides) {
    if (fill.front() != '#' || fill == "#f7f3e8") continue;
    CAPTURE(fill);
    const bool is_red = fill.substr(1, 2) > fill.substr(3, 2);
    CHECK(is_red == (fill[1] == 'f'));  // the cornice
  }
  CHECK(fills(R"({"colours": "none"})") == std::set<std::string>{"#ffffff", "url(#unknown)"});
  CHECK(fills(R"({"colours": "depth"})").size() == 5);
}

TEST_CASE("elevation: each facade alone, seen from its own front") {
  Model m = named_facade::make({});
  // A second facade: the same turned by 90 degrees, seen from +X.
  named_facade::Setting s;
  s.columns = 2;
  const Model other = named_facade::make(s);
  const auto turned = [](const Vec3& p) { return Vec3{-p.y + 30, p.x, p.z}; };
  const auto parts = static_cast<uint32_t>(m.parts.size());
  const uint64_t vertices = m.vertices.size(), corners = m.corners.size(), rings = m.rings.size();
  for (const Vec3& p : other.vertices) m.vertices.push_back(turned(p));
  for (const uint32_t c : other.corners) m.corners.push_back(static_cast<uint32_t>(c + vertices));
  m.sagittas.insert(m.sagittas.end(), other.sagittas.begin(), other.sagittas.end());
  for (Ring r : other.rings) {
    r.first += corners;
    if (r.part != kNoPart) r.part += parts;
    m.rings.push_back(r);
  }
  for (Face f : other.faces) {
    f.first_ring += rings;
    f.part += parts;
    const Vec3 n = f.plane.normal;
    f.plane.normal = {-n.y, n.x, n.z};
    m.faces.push_back(f);
  }
  for (Part p : other.parts) {
    if (p.parent != kNoParent) p.parent += parts;
    if (p.part_class == part_class::kFacade) p.name = "facade 2";
    m.parts.push_back(p);
  }
  const std::string first = drawing_of(m, R"({"facade": 1})"),
                    second = drawing_of(m, R"({"facade": 2})");
  check_layout(first);
  check_layout(second);
  CHECK(has_text(first, "Facade elevation: facade 1"));
  CHECK(has_text(first, "15.00"));
  CHECK(has_text(second, "Facade elevation: facade 2"));
  CHECK(has_text(second, "6.00"));
  CHECK(has_text(second, "270.0\xC2\xB0"));
  CHECK(paths(first, "opening").size() == 15);
  CHECK(paths(second, "opening").size() == 6);
  CHECK_THROWS_AS(drawing_of(m, R"({"facade": 3})"), Error);
}

TEST_CASE("elevation: a facade without openings has no table of them") {
  named_facade::Setting s;
  s.rows = 1;
  s.columns = 1;
  Model m = named_facade::make(s);  // a door alone
  CHECK(has_text(drawing_of(m), "Openings"));
  for (Part& p : m.parts)
    if (p.part_class == part_class::kDoor)
      p.parent = kNoParent, p.part_class = part_class::kElement;
  CHECK(!has_text(drawing_of(m), "Openings"));
}

TEST_CASE("elevation: what stands far in front of every wall is left out") {
  Model m = named_facade::make({});
  m.parts.push_back(named_facade::part("car", part_class::kElement, 0));
  named_facade::add(m, static_cast<uint32_t>(m.parts.size() - 1), {{0, -1, 0}, 5},
                    {named_facade::lifted({{1, 0}, {4, 0}, {4, 1.5}, {1, 1.5}}, -5)}, {}, 4.5, 20);
  CHECK(!has_text(drawing_of(m), "-5.00"));
  CHECK(has_text(drawing_of(m, R"({"element_reach_m": 6})"), "-5.00"));
}

TEST_CASE("elevation: source and date stand in the title block when given") {
  const Model m = named_facade::make({});
  const std::string svg = drawing_of(m, R"({"source": "a.las", "date": "2026-03-01"})");
  check_layout(svg);
  CHECK(has_text(svg, "a.las"));
  CHECK(has_text(svg, "2026-03-01"));
  CHECK(!has_text(drawing_of(m), "Date"));
}
