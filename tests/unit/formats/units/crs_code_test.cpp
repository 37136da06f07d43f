// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The EPSG code of a CRS text, of metric systems only: all spellings of one system, and those that must give none.
#include <doctest/doctest.h>

#include <string>

#include "formats/units/crs_code.h"

using namespace jalon;

namespace {

std::string wkt1(const std::string& unit, const std::string& authority) {
  return "PROJCS[\"p\",GEOGCS[\"g\",DATUM[\"d\",SPHEROID[\"s\",6378137,298.25,AUTHORITY[\"EPSG\","
         "\"7019\"]]],"
         "UNIT[\"degree\",0.0174532925,AUTHORITY[\"EPSG\",\"9122\"]],AUTHORITY[\"EPSG\",\"4171\"]],"
         "PROJECTION[\"Lambert\"]," +
         unit + authority + "]";
}

const std::string kMetre = "UNIT[\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]]";

}  // namespace

TEST_CASE("crs_code__every_spelling_of_a_metric_system_gives_its_code") {
  for (const char* text :
       {"EPSG:2154", "epsg:2154", "urn:ogc:def:crs:EPSG::2154", "urn:ogc:def:crs:EPSG:9.9.1:2154",
        "URN:OGC:DEF:CRS:epsg::2154", "http://www.opengis.net/def/crs/EPSG/0/2154",
        "https://www.opengis.net/def/crs/EPSG/0/2154",
        "PROJCRS[\"p\",BASEGEOGCRS[\"b\",DATUM[\"d\",ELLIPSOID[\"e\",6378137,298.25]],ID[\"EPSG\","
        "4171]],"
        "CS[Cartesian,2],AXIS[\"E\",east],AXIS[\"N\",north],LENGTHUNIT[\"metre\",1],ID[\"EPSG\","
        "2154]]"}) {
    CAPTURE(text);
    CHECK(metric_epsg_code(text) == 2154);
  }
  CHECK(metric_epsg_code(wkt1(kMetre, ",AUTHORITY[\"EPSG\",\"2154\"]")) == 2154);
  CHECK(metric_epsg_code("EPSG:999999") == 999999);
}

TEST_CASE("crs_code__of_a_wkt_the_identifier_of_the_whole_counts_and_none_of_its_parts") {
  CHECK(metric_epsg_code(wkt1(kMetre, "")) ==
        0);  // those of the datum, the unit and the degrees below
  CHECK(metric_epsg_code(wkt1(kMetre, ",AUTHORITY[\"IGNF\",\"2154\"]")) == 0);
  const std::string plane = wkt1(kMetre, ",AUTHORITY[\"EPSG\",\"2154\"]");
  const std::string height = "VERT_CS[\"h\"," + kMetre + ",AUTHORITY[\"EPSG\",\"5720\"]]";
  CHECK(metric_epsg_code("COMPD_CS[\"c\"," + plane + "," + height + "]") == 0);
  CHECK(metric_epsg_code("COMPD_CS[\"c\"," + plane + "," + height +
                         ",AUTHORITY[\"EPSG\",\"5698\"]]") == 5698);
  // Brackets and words inside a name are a name.
  for (const char* name : {"a [", "a ]", "AUTHORITY[", "( ID[ (", "]]]]"}) {
    CAPTURE(name);
    const std::string start = std::string("PROJCS[\"") + name + "\"," + kMetre;
    CHECK(metric_epsg_code(start + ",AUTHORITY[\"EPSG\",\"2154\"]]") == 2154);
    CHECK(metric_epsg_code(start + "]") == 0);
  }
}

TEST_CASE("crs_code__of_a_wkt_is_also_known_where_its_unit_is_not_the_metre") {
  CHECK(wkt_epsg_code(wkt1(kMetre, ",AUTHORITY[\"EPSG\",\"2154\"]")) == 2154);
  CHECK(wkt_epsg_code(wkt1("UNIT[\"foot\",0.3048]", ",AUTHORITY[\"EPSG\",\"2263\"]")) == 2263);
  CHECK(wkt_epsg_code("GEOGCRS[\"g\",ID[\"EPSG\",4326]]") == 4326);
  CHECK(wkt_epsg_code(wkt1(kMetre, "")) == 0);
  CHECK(wkt_epsg_code("EPSG:2154") == 0);
  CHECK(wkt_epsg_code("") == 0);
}

TEST_CASE("crs_code__systems_in_feet_or_degrees_and_texts_that_are_no_code_give_none") {
  const std::string foot = "UNIT[\"US survey foot\",0.304800609601219]";
  CHECK(metric_epsg_code("EPSG:2263") == 0);  // New York Long Island, US survey feet
  CHECK(metric_epsg_code("urn:ogc:def:crs:EPSG::2263") == 0);
  CHECK(metric_epsg_code(wkt1(foot, ",AUTHORITY[\"EPSG\",\"2263\"]")) == 0);
  CHECK(metric_epsg_code("PROJCS[\"p\",AUTHORITY[\"EPSG\",\"2263\"]]") == 0);  // names no unit
  CHECK(metric_epsg_code("PROJCRS[\"p\",ID[\"EPSG\",2263]]") == 0);
  CHECK(metric_epsg_code(wkt1(kMetre, ",AUTHORITY[\"EPSG\",\"2263\"]")) == 0);  // and another
  CHECK(metric_epsg_code("PROJCS[\"p\",AUTHORITY[\"EPSG\",\"2154\"]]") == 2154);
  CHECK(metric_epsg_code("GEOGCS[\"g\",AUTHORITY[\"EPSG\",\"4326\"]]") == 0);
  CHECK(metric_epsg_code("EPSG:4326") == 0);
  CHECK(metric_epsg_code("COMPD_CS[\"c\"," + wkt1(kMetre, "") + ",VERT_CS[\"h\"," + foot +
                         "],AUTHORITY[\"EPSG\",\"5698\"]]") == 0);
  for (const char* text :
       {"", "EPSG", "EPSG:", "EPSG:0", "EPSG:-1", "EPSG:2154x", "EPSG:2154 ", "EPSG:1000000",
        "EPSG:99999999999999999999", "EPSG:2154+5720", "2154", "site grid", "[",
        "AUTHORITY[\"EPSG\",\"2154\"]", "PROJCS[\"p\",AUTHORITY[",
        "PROJCS[\"p\",AUTHORITY[\"EPSG\",", "urn:ogc:def:crs:OGC:1.3:CRS84"}) {
    CAPTURE(text);
    CHECK(metric_epsg_code(text) == 0);
  }
}

TEST_CASE("crs_code__a_local_system_is_told_by_its_keyword_in_both_forms_of_wkt") {
  for (const char* crs :
       {"LOCAL_CS[\"a\",UNIT[\"metre\",1]]", " engcrs (\"a\")", "EngineeringCRS[\"a\"]"})
    CHECK_MESSAGE(is_local_crs(crs), crs);
  for (const char* crs : {"", "EPSG:2154", "PROJCS[\"LOCAL_CS\"]", "LOCAL_CSX[\"a\"]", "LOCAL"})
    CHECK_MESSAGE(!is_local_crs(crs), crs);
}
