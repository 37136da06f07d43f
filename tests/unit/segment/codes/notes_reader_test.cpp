// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/notes_reader.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "segment/codes/notes.h"
#include "unit/segment/codes/coded.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string notes_of(const CodedObjects& all) {
  return coded_notes("survey_codes", all, std::vector<uint32_t>(all.objects.size(), 7),
                     std::vector<uint64_t>(all.objects.size(), 11), {{0, 3}, {1, 11}});
}

const NotedObject* noted(const CodedNotes& notes, const std::string& name) {
  for (const NotedObject& o : notes.objects)
    if (o.name == name) return &o;
  return nullptr;
}

}  // namespace

TEST_CASE("notes_reader__brings_back_what_was_written") {
  const CodedObjects all = surveyed(code_list_of(kAnnexSurvey));
  const CodedNotes notes = read_coded_notes(notes_of(all));
  CHECK(notes.method == "survey_codes");
  REQUIRE(notes.objects.size() == all.objects.size());
  for (size_t i = 0; i < all.objects.size(); ++i) {
    const NotedObject& back = notes.objects[i];
    const CodedObject& object = all.objects[i];
    CHECK(back.name == object.name);
    CHECK(back.geometry == name_of(object.row.geometry));
    CHECK(back.label == 7);
    CHECK(back.points == 11);
    REQUIRE(back.surveyed.size() == object.points.size());
    for (size_t k = 0; k < object.points.size(); ++k) {
      CHECK(back.surveyed[k].id == object.points[k].id);
      CHECK(back.surveyed[k].line == object.points[k].line);
      CHECK(back.surveyed[k].place == object.points[k].position);
    }
    CHECK(back.outline.size() == (object.shape.kind == CodeShape::Kind::kPrism
                                      ? object.shape.polygon.size()
                                  : object.shape.kind == CodeShape::Kind::kRectangle ? 4
                                                                                     : 0));
    CHECK(back.axis.size() == object.shape.axis.size());
  }
  CHECK(noted(notes, "building 255")->surveyed[0].code == "300.2");
  CHECK(noted(notes, "window 167")->surveyed[0].code == "360");
  CHECK(noted(notes, "building 255")->outline[1].z == doctest::Approx(249.745));
  CHECK(notes.classes[1].points == 11);
  CHECK(notes.warnings.size() == 2);
  CHECK(notes.warnings[0].object == "window 181");
}

TEST_CASE("notes_reader__outlines_of_openings_lie_in_space") {
  const CodedNotes notes = read_coded_notes(
      notes_of(surveyed("1;0;0;1;365.2\n2;3;4;1;365.4\n3;3;4;2;365.4\n4;1.5;2;3;365.0\n")));
  const std::vector<Vec3>& outline = notes.objects[0].outline;
  REQUIRE(outline.size() == 4);
  const Vec3 corners[] = {{0, 0, 1}, {3, 4, 1}, {3, 4, 2}, {1.5, 2, 3}};
  for (size_t k = 0; k < 4; ++k) CHECK(norm(outline[k] - corners[k]) < 1e-9);
}

TEST_CASE("notes_reader__refuses_what_it_did_not_write") {
  CHECK(read_coded_notes("").objects.empty());
  const std::string good = notes_of(surveyed("1;0;0;0;360\n2;1;0;1;360\n"));
  CHECK(read_coded_notes(good).objects.size() == 1);
  const auto broken = [&](const std::string& what, const std::string& by) {
    std::string text = good;
    text.replace(text.find(what), what.size(), by);
    CHECK_THROWS_AS(read_coded_notes(text), Error);
  };
  broken("\"name\"", "\"nome\"");
  broken("\"label\":7", "\"label\":-7");
  broken("\"ids\":[\"1\",\"2\"]", "\"ids\":[\"1\",\"2\",\"3\"]");
  broken("\"places\":[[0.0,", "\"places\":[[\"a\",");
  broken("\"low_m\":0.0", "\"low_m\":null");
  CHECK_THROWS_AS(read_coded_notes("[]"), Error);
}
