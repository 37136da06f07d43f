// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/units/length_units.h"

#include "formats/files/endian.h"
#include "formats/las/layout.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr const char* kGeographic =
    "GEOGCS[\"NAD83\",DATUM[\"d\",SPHEROID[\"s\",6378137,298.25]],"
    "UNIT[\"degree\",0.0174532925199433]]";

std::string projected(const std::string& unit) {
  return std::string("PROJCS[\"p\",") + kGeographic + ",PROJECTION[\"Lambert\"]," + unit + "]";
}

std::vector<las::Record> keys(const std::vector<uint16_t>& words) {
  std::vector<std::byte> bytes(2 * words.size());
  for (size_t i = 0; i < words.size(); ++i) store<uint16_t>(bytes.data() + 2 * i, words[i]);
  return {las::make_record("LASF_Projection", 34735, "", bytes.data(), bytes.size())};
}

las::Record wkt_record(const std::string& text) {
  return las::make_record("LASF_Projection", 2112, "", text.c_str(), text.size() + 1);
}

void expect(const LengthUnits& units, double horizontal, double vertical) {
  CHECK(units.known);
  CHECK(!units.degrees);
  CHECK(units.horizontal == doctest::Approx(horizontal).epsilon(1e-12));
  CHECK(units.vertical == doctest::Approx(vertical).epsilon(1e-12));
}

}  // namespace

TEST_CASE("length_units__wkt1_takes_the_unit_of_the_projected_system_not_of_the_degrees_below") {
  expect(units_of_crs(projected("UNIT[\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]]")), 1, 1);
  expect(units_of_crs(projected("UNIT[\"foot\",0.3048,AUTHORITY[\"EPSG\",\"9002\"]]")), kFoot,
         kFoot);
  expect(units_of_crs(projected("UNIT[\"US survey foot\",0.304800609601219]")), 0.304800609601219,
         0.304800609601219);
  expect(units_of_crs("LOCAL_CS[\"site\",UNIT[\"foot\",0.3048]]"), kFoot, kFoot);
}

TEST_CASE("length_units__wkt2_takes_the_unit_of_the_axes_or_of_the_system") {
  const std::string base =
      "PROJCRS[\"p\",BASEGEOGCRS[\"b\",DATUM[\"d\",ELLIPSOID[\"e\",6378137,298.25,"
      "LENGTHUNIT[\"metre\",1]]]],CONVERSION[\"c\",METHOD[\"m\"],PARAMETER[\"False "
      "easting\",1000,LENGTHUNIT[\"metre\",1]]],CS[Cartesian,2],";
  expect(units_of_crs(base + "AXIS[\"E\",east],AXIS[\"N\",north],LENGTHUNIT[\"foot\",0.3048]]"),
         kFoot, kFoot);
  expect(units_of_crs(base + "AXIS[\"E\",east,LENGTHUNIT[\"foot\",0.3048]],"
                             "AXIS[\"N\",north,LENGTHUNIT[\"foot\",0.3048]]]"),
         kFoot, kFoot);
  expect(units_of_crs(base + "AXIS[\"E\",east],AXIS[\"N\",north],LENGTHUNIT[\"metre\",1]]"), 1, 1);
}

TEST_CASE("length_units__a_projected_system_that_names_no_unit_has_that_of_its_code") {
  for (const char* feet : {"PROJCS[\"p\",AUTHORITY[\"EPSG\",\"2263\"]]",
                           " PROJCRS[\"p\",CS[Cartesian,2],AXIS[\"E\",east],ID[\"EPSG\",2263]]"})
    expect(units_of_crs(feet), kUsFoot, kUsFoot);
  const std::string metres = "UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"2263\"]";
  expect(units_of_crs(projected(metres)), 1, 1);  // what it names goes first
  expect(units_of_crs("PROJCS[\"p\",AUTHORITY[\"EPSG\",\"2154\"]]"), 1, 1);
  CHECK(!units_of_crs("PROJCS[\"p\",AUTHORITY[\"IGNF\",\"2263\"]]").known);
  CHECK(!units_of_crs("COMPD_CS[\"c\",AUTHORITY[\"EPSG\",\"2263\"]]").known);
}

TEST_CASE("length_units__a_compound_system_has_its_own_unit_of_height") {
  const std::string feet = projected("UNIT[\"foot\",0.3048]");
  const std::string metres = projected("UNIT[\"metre\",1]");
  const auto compound = [](const std::string& plane, const std::string& height) {
    return "COMPD_CS[\"c\"," + plane + ",VERT_CS[\"v\",VERT_DATUM[\"d\",2005],UNIT[" + height +
           "],AXIS[\"Up\",UP]]]";
  };
  expect(units_of_crs(compound(feet, "\"metre\",1")), kFoot, 1);
  expect(units_of_crs(compound(metres, "\"foot\",0.3048")), 1, kFoot);
  expect(units_of_crs(compound(feet, "\"foot\",0.3048")), kFoot, kFoot);
}

TEST_CASE("length_units__degrees_and_unknown_texts_are_told_apart") {
  CHECK(units_of_crs(kGeographic).degrees);
  CHECK(units_of_crs("EPSG:4326").degrees);
  CHECK(!units_of_crs("EPSG:2154").degrees);
  for (const char* text : {"", "site grid", "EPSG:", "EPSG:12x", "[", "UNIT[\"foot\",0.3048]",
                           "PROJCS[\"UNIT[\\\"foot\\\",0.3048]", "PROJCS[UNIT[\"foot\",]]",
                           "PROJCS[\"p\",UNIT[\"foot\",nan]]", "PROJCS[\"p\",UNIT[\"foot\",-1]]"}) {
    CAPTURE(text);
    CHECK(!units_of_crs(text).known);
    CHECK(units_of_crs(text).metres());
  }
}

TEST_CASE("length_units__epsg_codes_in_feet_are_known") {
  expect(units_of_crs("EPSG:2154"), 1, 1);                // RGF93 / Lambert-93
  expect(units_of_crs("epsg:2263"), kUsFoot, kUsFoot);    // NAD83 / New York Long Island (ftUS)
  expect(units_of_crs("EPSG:2992"), kFoot, kFoot);        // NAD83 / Oregon LCC (ft)
  expect(units_of_crs("EPSG:32631"), 1, 1);               // WGS 84 / UTM zone 31N
  CHECK(unit_of_epsg(6360) == doctest::Approx(kUsFoot));  // NAVD88 height (ftUS)
}

TEST_CASE("length_units__geo_keys_give_the_unit_of_the_plane_and_of_the_height") {
  const auto of = [](const std::vector<uint16_t>& words) {
    return las::units_of(keys(words), {}, "a.las");
  };
  expect(of({1, 1, 0, 1, 3076, 0, 1, 9001}), 1, 1);
  expect(of({1, 1, 0, 1, 3076, 0, 1, 9002}), kFoot, kFoot);
  expect(of({1, 1, 0, 1, 3076, 0, 1, 9003}), kUsFoot, kUsFoot);
  expect(of({1, 1, 0, 2, 3076, 0, 1, 9003, 4099, 0, 1, 9001}), kUsFoot, 1);
  expect(of({1, 1, 0, 2, 3076, 0, 1, 9001, 4099, 0, 1, 9002}), 1, kFoot);
  expect(of({1, 1, 0, 1, 3072, 0, 1, 2263}), kUsFoot, kUsFoot);
  expect(of({1, 1, 0, 2, 3072, 0, 1, 2263, 3076, 0, 1, 9001}), 1, 1);  // the unit key goes first
  CHECK(of({1, 1, 0, 1, 1024, 0, 1, 2}).degrees);
  CHECK(!of({1, 1, 0, 0}).known);
  const Failure unknown = failure_of([&] { of({1, 1, 0, 1, 3076, 0, 1, 9999}); });
  CHECK(unknown.status == Status::kUnsupported);
  CHECK(unknown.text.find("9999") != std::string::npos);
}

TEST_CASE("length_units__two_records_must_agree") {
  const auto both = [](uint16_t unit, const std::string& wkt) {
    std::vector<las::Record> records = keys({1, 1, 0, 1, 3076, 0, 1, unit});
    records.push_back(wkt_record(wkt));
    return las::units_of(records, {}, "a.las");
  };
  expect(both(9002, projected("UNIT[\"foot\",0.3048]")), kFoot, kFoot);
  expect(both(9003, projected("UNIT[\"US survey foot\",0.304800609601]")), kUsFoot, kUsFoot);
  const Failure failure = failure_of([&] { both(9002, projected("UNIT[\"metre\",1]")); });
  CHECK(failure.status == Status::kUnsupported);
  CHECK(failure.text.find("contradict") != std::string::npos);
}
