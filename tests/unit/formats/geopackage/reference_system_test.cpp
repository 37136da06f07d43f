// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/geopackage/reference_system.h"

#include "unit/formats/geopackage/opened_package.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr char kWktWithoutCode[] =
    "PROJCS[\"works grid\",GEOGCS[\"g\",DATUM[\"d\",SPHEROID[\"s\",6378137,298.25]],"
    "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],"
    "PROJECTION[\"Transverse_Mercator\"],UNIT[\"metre\",1]]";

// srs_id of the faces, and how many systems the file lists.
std::pair<std::string, std::string> listed(const std::string& crs) {
  Model model;
  model.crs = crs;
  const OpenedPackage package(model);
  return {package.value("SELECT srs_id FROM gpkg_contents WHERE table_name = 'faces'"),
          package.value("SELECT count(*) FROM gpkg_spatial_ref_sys")};
}

using Listed = std::pair<std::string, std::string>;

}  // namespace

TEST_CASE("gpkg_reference_system__a_metric_code_is_the_srs_id_whatever_says_it") {
  if (!has_sqlite()) return;
  CHECK(listed("EPSG:2154") == Listed{"2154", "4"});
  CHECK(listed("urn:ogc:def:crs:EPSG::25832") == Listed{"25832", "4"});
}

TEST_CASE(
    "gpkg_reference_system__local_unknown_and_foreign_units_are_a_cartesian_plane_never_degrees") {
  if (!has_sqlite()) return;
  for (const char* crs :
       {"", "LOCAL_CS[\"site\",UNIT[\"metre\",1]]", "EPSG:4326", "nonsense", "EPSG:2225"})
    CHECK(listed(crs) == Listed{"-1", "3"});
}

TEST_CASE("gpkg_reference_system__wkt_without_code_keeps_its_definition") {
  if (!has_sqlite()) return;
  CHECK(listed(kWktWithoutCode) == Listed{"100000", "4"});
  Model model;
  model.crs = kWktWithoutCode;
  const OpenedPackage package(model);
  CHECK(
      package.rows("SELECT srs_name, definition FROM gpkg_spatial_ref_sys WHERE srs_id = 100000") ==
      Rows{{"works grid", kWktWithoutCode}});
}
