// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/code_plan.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/report/coded_house.h"
#include "unit/report/markup.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string plan_of_house(const std::string& codes = kCodedHouse) {
  const Segmentation s = coded_house(codes);
  Task task;
  return code_plan_svg(s, read_coded_notes(s.notes_json), "House & yard", task);
}

size_t texts(const std::string& svg, const std::string& text) {
  size_t count = 0;
  for (const markup::TextBox& box : markup::text_boxes(svg)) count += box.text == text;
  return count;
}

}  // namespace

TEST_CASE("code_plan__shows_codes_objects_classes_and_a_scale_bar") {
  const std::string svg = plan_of_house();
  CHECK(markup::well_formed(svg));
  CHECK(svg.find("House &amp; yard: plan, 4 coded objects") != std::string::npos);
  CHECK(texts(svg, "300.2") == 1);
  CHECK(texts(svg, "300.4") >= 3);
  CHECK(texts(svg, "408") == 1);
  CHECK(texts(svg, "door  (90)") == 1);
  CHECK(texts(svg, "N") == 1);
  CHECK(texts(svg, "East (m)") == 1);
  size_t images = 0, circles = 0;
  for (const markup::Tag& tag : markup::tags(svg)) {
    images += tag.name == "image";
    circles += tag.name == "circle";
  }
  CHECK(images == 1);
  CHECK(circles >= 12 + 1 + 2);  // the points, the gutter, the legend
}

TEST_CASE("code_plan__codes_do_not_cover_each_other") {
  std::string codes = kCodedHouse;
  for (int i = 0; i < 40; ++i) {
    const std::string x = text_of(5 + 0.01 * i, 2);
    codes += std::to_string(100 + 2 * i) + ";" + x + ";0.2;1;360\n" + std::to_string(101 + 2 * i) +
             ";" + text_of(5.5 + 0.01 * i, 2) + ";0.2;2;360\n";
  }
  const std::string svg = plan_of_house(codes);
  std::vector<markup::TextBox> placed;
  for (const markup::TextBox& box : markup::text_boxes(svg))
    if (box.text.rfind("3", 0) == 0 && box.text.size() <= 5 && box.bottom - box.top < 1.2)
      placed.push_back(box);
  CHECK(placed.size() >= 6);
  for (size_t i = 0; i < placed.size(); ++i)
    for (size_t k = 0; k < i; ++k) CHECK(!placed[i].meets(placed[k]));
  CHECK(svg.find("codes have no room here") != std::string::npos);
}

TEST_CASE("code_plan__classes_have_the_colours_of_their_source") {
  CHECK(class_colour(1).green > class_colour(1).red);
  CHECK(class_colour(4).red > class_colour(4).green);
  CHECK(class_colour(0).blue > class_colour(0).red);
  CHECK(!(class_colour(2) == class_colour(3)));
  CHECK(class_colour(7) == class_colour(10));  // of one's own: three colours in turn
}

TEST_CASE("code_plan__a_slip_of_the_survey_neither_widens_it_nor_ends_it") {
  const Segmentation s = coded_house(kCodedHouse);
  CodedNotes notes = read_coded_notes(s.notes_json);
  Task task;
  const std::string whole = code_plan_svg(s, notes, "", task);
  const auto image = [](const std::string& svg) {
    return svg.substr(svg.find("<image"), svg.find("/>", svg.find("<image")));
  };
  REQUIRE(!notes.objects.empty());
  for (const double far_m : {1e9, 1e12, 1e300}) {
    CAPTURE(far_m);
    NotedObject lost = notes.objects.front();
    lost.shape = "none", lost.outline.clear(), lost.axis.clear();
    lost.surveyed.assign(1, {"9", "300", 9, {far_m, 0, 0}});
    CodedNotes with = notes;
    with.objects.push_back(lost);
    const std::string svg = code_plan_svg(s, with, "", task);
    CHECK(markup::well_formed(svg));
    CHECK(image(svg).size() > 100);
    CHECK(svg.size() < 2 * whole.size());
  }
  notes.objects.front().shape = "cylinder";  // one without an axis, of bytes that somebody made
  notes.objects.front().outline.clear(), notes.objects.front().axis.clear();
  CHECK(markup::well_formed(code_plan_svg(s, notes, "", task)));
}

TEST_CASE("code_plan__without_objects_shows_the_cloud") {
  const std::string svg = plan_of_house("");
  CHECK(markup::well_formed(svg));
  CHECK(svg.find("0 coded objects") != std::string::npos);
}
