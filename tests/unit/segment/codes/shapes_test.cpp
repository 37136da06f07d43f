// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "unit/segment/codes/coded.h"

using namespace jalon;
using namespace jalon::test;

namespace {

CodedObjects annex() { return surveyed(code_list_of(kAnnexSurvey)); }

double area_of(const CodedObjects& all, const char* building) {
  return std::fabs(signed_area(object_named(all, building)->shape.polygon));
}

}  // namespace

TEST_CASE("shapes__outlines_of_the_annex_have_the_stated_areas") {
  const CodedObjects all = annex();
  CHECK(std::fabs(area_of(all, "building 100") - 296.3) < 0.05);
  CHECK(std::fabs(area_of(all, "building 255") - 299.6) < 0.05);
  CHECK(std::fabs(area_of(all, "building 156") - 655.0) < 0.05);
  CHECK(std::fabs(area_of(all, "building 500") - 299.3) < 0.05);
  const CodeShape& c = object_named(all, "building 156")->shape;
  CHECK(c.polygon.size() == 12);
  CHECK(c.low_m + all.origin.z == doctest::Approx(246.706));
  CHECK(c.high_m + all.origin.z == doctest::Approx(249.773));
}

TEST_CASE("shapes__gutters_of_the_annex_have_the_stated_radii_and_lengths") {
  const CodedObjects all = annex();
  double sum = 0;
  int gutters = 0;
  for (const CodedObject& object : all.objects) {
    if (object.row.name != "gutter") continue;
    REQUIRE(object.shape.kind == CodeShape::Kind::kPipe);
    CHECK(object.shape.radius_m > 0.0305);
    CHECK(object.shape.radius_m < 0.0485);
    const double length = object.shape.high_m - object.shape.low_m;
    CHECK(length > 2.685);
    CHECK(length < 2.865);
    sum += object.shape.radius_m;
    ++gutters;
  }
  CHECK(gutters == 12);
  CHECK(std::fabs(sum / gutters - 0.039) < 0.001);
}

TEST_CASE("shapes__exactly_two_openings_of_the_annex_are_flagged") {
  const CodedObjects all = annex();
  int doors = 0, windows = 0;
  for (const CodedObject& object : all.objects)
    if (object.shape.kind == CodeShape::Kind::kRectangle)
      ++(object.row.name == "door" ? doors : windows);
  CHECK(doors == 19);
  CHECK(windows == 98);
  CHECK(all.warnings.size() == 2);
  CHECK(warning_of(all, "window 181").text.find("2.231 m") != std::string::npos);
  CHECK(warning_of(all, "window 629").text.find("12.0") != std::string::npos);
}

TEST_CASE("shapes__openings_of_the_annex_lie_at_the_frames") {
  // 3.6 of the facade template: depth behind the outline, range of heights.
  const CodedObjects all = annex();
  const auto depth = [&](const char* building, const char* opening) {
    const CodeShape& s = object_named(all, opening)->shape;
    const Vec3 middle = 0.5 * (s.corner_a + s.corner_b);
    return border_distance(object_named(all, building)->shape.polygon, {middle.x, middle.y});
  };
  CHECK(std::fabs(depth("building 255", "window 220") - 0.16) < 0.006);
  CHECK(std::fabs(depth("building 255", "window 666") - 0.18) < 0.006);
  CHECK(std::fabs(depth("building 255", "door 419") - 0.10) < 0.006);
  CHECK(std::fabs(depth("building 156", "window 205") - 0.17) < 0.006);
  CHECK(std::fabs(depth("building 500", "door 437") - 0.13) < 0.006);
  const CodeShape& w = object_named(all, "window 220")->shape;
  CHECK(w.low_m + all.origin.z == doctest::Approx(247.73).epsilon(5e-5));
  CHECK(w.high_m + all.origin.z == doctest::Approx(248.899));
}

TEST_CASE("shapes__a_door_opens_on_the_side_that_was_measured_first") {
  // A house of 10 x 8 m, either way round; the viewer of its front y = 0 has x = 1 at the left.
  const char* houses[] = {
      "1;0;0;3;300.2\n2;10;0;3;300.4\n3;10;8;3;300.4\n4;0;8;3;300.4\n5;0;0;0;300.4\n",
      "1;0;0;3;300.2\n4;0;8;3;300.4\n3;10;8;3;300.4\n2;10;0;3;300.4\n5;0;0;0;300.4\n"};
  for (const char* house : houses) {
    const CodedObjects all = surveyed(std::string(house) +
                                      "6;1;0.1;0;350\n7;2;0.1;2;350\n"
                                      "8;5;0.1;0;350\n9;4;0.1;2;350\n"
                                      "10;5;7.9;0;350\n11;4;7.9;2;350\n"
                                      "12;50;0;0;350\n13;51;0;2;350\n");
    CHECK(object_named(all, "door 6")->hinge == Hinge::kLeft);
    CHECK(object_named(all, "door 8")->hinge == Hinge::kRight);
    CHECK(object_named(all, "door 10")->hinge == Hinge::kLeft);
    CHECK(object_named(all, "door 12")->hinge == Hinge::kUnknown);
  }
}

TEST_CASE("shapes__a_building_without_a_low_point_keeps_its_corners") {
  const CodedObjects all =
      surveyed("1;0;0;3;300.2\n2;10;0;3.01;300.4\n3;10;8;3;300.4\n4;0;8;2.99;300.4\n");
  CHECK(area_of(all, "building 1") == doctest::Approx(80));
  CHECK(warning_of(all, "building 1").text.find("low point") != std::string::npos);
}

TEST_CASE("shapes__outlines_that_hold_nothing_are_left_out_by_name") {
  const CodedObjects all = surveyed(
      "1;0;0;3;300.2\n2;10;0;3;300.4\n3;0;0;0;300.4\n"
      "4;0;0;3;301.2\n5;9;9;3;301.4\n6;9;0;3;301.4\n7;0;9;3;301.4\n8;0;0;0;301.4\n");
  for (const CodedObject& object : all.objects) CHECK(object.shape.kind == CodeShape::Kind::kNone);
  CHECK(warning_of(all, "building 1").line == 1);
  CHECK(warning_of(all, "building 4").text.find("crosses itself") != std::string::npos);
}

TEST_CASE("shapes__an_outline_is_a_polygon_in_its_wall") {
  // A gable window: 2 m wide, 1 m high at its sides, 2 m in the middle; on the line y = x.
  const double q = std::sqrt(0.5);
  const auto point = [&](int id, double along, double z, const char* code) {
    return std::to_string(id) + ";" + text_of(along * q) + ";" + text_of(along * q) + ";" +
           text_of(z) + ";" + code + "\n";
  };
  const std::string open = point(1, 1, 1, "365.2") + point(2, 3, 1, "365.4") +
                           point(3, 3, 2, "365.4") + point(4, 2, 3, "365.4");
  for (const bool closed : {true, false}) {
    const CodedObjects all = surveyed(open + point(5, 1, 2, closed ? "365.0" : "365.4"));
    const CodedObject& window = *object_named(all, "window 1");
    REQUIRE(window.shape.kind == CodeShape::Kind::kOutline);
    CHECK(std::fabs(signed_area(window.shape.polygon)) == doctest::Approx(3));
    CHECK((warning_of(all, "window 1").text.find("not closed") != std::string::npos) == !closed);
  }
}

TEST_CASE("shapes__a_gutter_with_bends_has_an_axis_and_the_radius_of_its_skin") {
  const CodedObjects all = surveyed(
      "1;0;0;0;415.2\n2;0.05;0;1;415.8\n3;0;0;2;415.4\n4;0.3;0;2.3;415.4\n5;9;0;0;415.2\n"
      "6;9;0;2;415.4\n7;5;0;0;408\n8;5;0;0;409\n9;5;0;2;410\n");
  const CodeShape& bent = object_named(all, "gutter 1")->shape;
  CHECK(bent.axis.size() == 3);
  CHECK(bent.radius_m == doctest::Approx(0.05));
  CHECK(object_named(all, "gutter 5")->shape.radius_m == 0.04);
  CHECK(warning_of(all, "gutter 5").line == 5);
  CHECK(object_named(all, "gutter 7")->shape.kind == CodeShape::Kind::kNone);
  CHECK(warning_of(all, "gutter 7").text.find("no radius") != std::string::npos);
}
