// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The pieces of a CityJSON text against where they stand in it, and what is no CityJSON against its refusal.
#include "formats/city/text.h"

#include <doctest/doctest.h>

#include "unit/formats/city/json_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// The first geometry of a list, classified.
struct ReadGeometry {
  explicit ReadGeometry(const std::string& list) : file(list), piece(file.piece()) {
    failure = failure_of([&] {
      JsonCursor cursor = piece.cursor();
      cursor.begin_array();
      REQUIRE(cursor.next_element());
      geometry = city::read_geometry_text(piece, cursor);
      city::classify(geometry, file.source(), piece);
    });
  }
  JsonFile file;
  city::Piece piece;
  city::GeometryText geometry = {};
  Failure failure = {};
};

Failure refused_file(const std::string& text) {
  JsonFile file(text);
  return failure_of([&] { city::read_file_text(file.source(), file.task(), file.text()); });
}

}  // namespace

TEST_CASE("city_text__pieces_know_where_they_stand_in_the_file_and_refuse_there") {
  JsonFile file(R"(  {"vertices": [ ], "extensions": {"vertices": 1}, "version": "1.1",
    "metadata":  {"title": "a"}, "CityObjects": {"b": {"geometry":   7}}, "type": "CityJSON"})");
  const city::FileText parts = city::read_file_text(file.source(), file.task(), file.text());
  CHECK(parts.transform.empty());
  CHECK(parts.vertices.offset() == file.text().find("[ ]"));
  CHECK(parts.metadata.offset() == file.text().find("{\"title\""));
  CHECK(parts.objects.offset() == file.text().find("{\"b\""));
  // A piece of a piece refuses with its place in the file.
  JsonCursor cursor = parts.objects.cursor();
  std::string name;
  cursor.begin_object();
  REQUIRE(cursor.next_member(name));
  const city::Piece inner = parts.objects.value(cursor);
  JsonCursor inside = inner.cursor();
  inside.begin_object();
  REQUIRE(inside.next_member(name));
  CHECK(name == "geometry");
  const Failure failure = failure_of([&] { inside.begin_array(); });
  CHECK(failure.status == Status::kFormat);
  CHECK(failure.text == file.source().path() + ": offset " +
                            std::to_string(file.text().find("7}")) +
                            ": no CityJSON: an array was expected");
}

TEST_CASE("city_text__files_of_other_kinds_are_refused_by_name") {
  const auto file_of = [](const char* type, const char* version, const char* rest) {
    return std::string("{\"type\": \"") + type + "\", \"version\": \"" + version + "\"" + rest +
           "}";
  };
  constexpr const char* kWhole = ", \"CityObjects\": {}, \"vertices\": []";
  for (const char* version : {"1.0", "1.1", "2.0"})
    CHECK(refused_file(file_of("CityJSON", version, kWhole)).status == Status::kOk);
  const Failure lines = refused_file(file_of("CityJSONFeature", "2.0", kWhole));
  CHECK(lines.status == Status::kUnsupported);
  CHECK(lines.text.find("text sequences") != std::string::npos);
  for (const char* version : {"0.9", "2.0.1", "3.0", ""}) {
    const Failure other = refused_file(file_of("CityJSON", version, kWhole));
    CHECK(other.status == Status::kUnsupported);
    CHECK(other.text.find("1.0, 1.1 and 2.0") != std::string::npos);
  }
  CHECK(refused_file(file_of("FeatureCollection", "2.0", kWhole)).status == Status::kFormat);
  for (const char* part : {", \"CityObjects\": {}", ", \"vertices\": []"}) {
    const Failure half = refused_file(file_of("CityJSON", "2.0", part));
    CHECK(half.status == Status::kFormat);
    CHECK(half.text.find("CityObjects or vertices are missing") != std::string::npos);
  }
  CHECK(refused_file(file_of("CityJSON", "2.0", kWhole) + "x").status == Status::kFormat);
}

TEST_CASE("city_text__level_of_detail_is_a_number_or_none") {
  const auto lod = [](const std::string& value) {
    return ReadGeometry("[{\"type\": \"Solid\", \"boundaries\": []" + value + "}]").geometry.lod;
  };
  CHECK(lod(", \"lod\": 2.2") == 2.2);      // 1.0
  CHECK(lod(", \"lod\": \"2.2\"") == 2.2);  // 1.1 and later
  CHECK(lod(", \"lod\": \"0\"") == 0);
  for (const char* none : {"", ", \"lod\": \"LOD2\"", ", \"lod\": \"\"", ", \"lod\": -7",
                           ", \"lod\": \"-0.5e9\"", ", \"lod\": \"inf\"", ", \"lod\": \"nan\""})
    CHECK(lod(none) == -1);
}

TEST_CASE("city_text__a_geometry_has_as_many_lists_as_its_type_says") {
  const auto typed = [](const char* type, const char* rest) {
    return ReadGeometry(std::string("[{\"type\": \"") + type + "\"" + rest + "}]");
  };
  const std::pair<const char*, int> kDepths[] = {{"MultiSurface", 0},
                                                 {"CompositeSurface", 0},
                                                 {"Solid", 1},
                                                 {"MultiSolid", 2},
                                                 {"CompositeSolid", 2}};
  constexpr const char* kMeaning =
      ", \"semantics\": {\"values\": [1], \"surfaces\": [2]}, \"boundaries\": [3]";
  for (const auto& [type, depth] : kDepths) {
    const ReadGeometry got = typed(type, kMeaning);
    CHECK(got.failure.status == Status::kOk);
    CHECK(got.geometry.has_surfaces);
    CHECK(got.geometry.depth == depth);
    JsonCursor surfaces = got.geometry.surfaces.cursor(), values = got.geometry.values.cursor();
    CHECK(surfaces.skip() == "[2]");
    CHECK(values.skip() == "[1]");
    const Failure empty = typed(type, ", \"semantics\": null").failure;
    CHECK(empty.status == Status::kFormat);
    CHECK(empty.text.find("without boundaries") != std::string::npos);
  }
  for (const char* type : {"MultiPoint", "MultiLineString"}) {
    CHECK(typed(type, "").failure.status == Status::kOk);
    CHECK_FALSE(typed(type, "").geometry.has_surfaces);
  }
  CHECK(typed("GeometryInstance", kMeaning).failure.status == Status::kUnsupported);
  CHECK(typed("Sphere", kMeaning).failure.text.find("unknown type") != std::string::npos);
}
