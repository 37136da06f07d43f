// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/geopackage/layer.h"

#include <array>

#include "formats/geopackage/reference_system.h"
#include "unit/formats/geopackage/opened_package.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::gpkg;
using namespace jalon::test;

TEST_CASE("gpkg_layer__the_lists_name_each_layer_with_the_box_of_its_rows") {
  if (!has_sqlite()) return;
  const OpenedPackage package(House().model());
  const Rows rows = package.rows(
      "SELECT c.table_name, c.data_type, c.srs_id, g.geometry_type_name, g.z, g.m FROM "
      "gpkg_contents c JOIN "
      "gpkg_geometry_columns g USING (table_name) ORDER BY c.table_name");
  CHECK(rows == Rows{{"elevation", "features", "-1", "POLYGON", "1", "0"},
                     {"faces", "features", "2154", "POLYGON", "1", "0"},
                     {"openings", "features", "2154", "POLYGON", "1", "0"},
                     {"plan", "features", "2154", "LINESTRING", "1", "0"}});
  CHECK(std::stod(
            package.value("SELECT min_x FROM gpkg_contents WHERE table_name = 'elevation'")) == 0);
  CHECK(std::stod(package.value("SELECT min_x FROM gpkg_contents WHERE table_name = 'faces'")) >
        652400);
}

TEST_CASE("gpkg_layer__one_without_rows_has_no_box") {
  if (!has_sqlite()) return;
  const OpenedPackage package({});
  CHECK(package.rows("SELECT min_x, max_y FROM gpkg_contents WHERE table_name = 'faces'") ==
        Rows{{"-", "-"}});
}
