// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/geopackage/reference_system.h"

#include <array>

#include "formats/files/utf8.h"
#include "formats/units/crs_code.h"
#include "formats/units/length_units.h"

namespace jalon::gpkg {

namespace {

constexpr int32_t kWgs84 = 4326;
constexpr int32_t kFirstOfUsers = 100000;  // above the codes of EPSG and ESRI's own
constexpr char kUndefined[] = "undefined";

// OGC 12-128r17, Table 3, as text of PROJ.
constexpr char kWgs84Definition[] =
    "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563,"
    "AUTHORITY[\"EPSG\",\"7030\"]],AUTHORITY[\"EPSG\",\"6326\"]],PRIMEM[\"Greenwich\",0,"
    "AUTHORITY[\"EPSG\",\"8901\"]],UNIT[\"degree\",0.0174532925199433,"
    "AUTHORITY[\"EPSG\",\"9122\"]],AUTHORITY[\"EPSG\",\"4326\"]]";

// The column "definition" wants WKT 1 (OGC 01-009).
bool is_wkt1_of_map(std::string_view crs) {
  const size_t start = crs.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return false;
  return crs.substr(start).starts_with("PROJCS[") || crs.substr(start).starts_with("COMPD_CS[");
}

// "RGF93 / Lambert-93" of PROJCS["RGF93 / Lambert-93",...
std::string name_in(const std::string& wkt) {
  const size_t first = wkt.find('"'), last = wkt.find('"', first + 1);
  return last == std::string::npos ? "" : wkt.substr(first + 1, last - first - 1);
}

}  // namespace

int32_t add_reference_systems(Database& database, const std::string& crs) {
  database.run(
      "CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT NOT NULL, srs_id INTEGER NOT NULL PRIMARY "
      "KEY, organization TEXT NOT NULL, organization_coordsys_id INTEGER NOT NULL, definition TEXT "
      "NOT NULL, description TEXT)");
  Insertion rows(database, "INSERT INTO gpkg_spatial_ref_sys VALUES (?, ?, ?, ?, ?, NULL)");
  const auto add = [&](const std::string& name, int64_t id, const char* organization, int64_t code,
                       const std::string& definition) {
    rows.add(std::array<Value, 5>{name, id, std::string(organization), code, definition});
  };
  add("Undefined Cartesian SRS", kLocalCartesian, "NONE", kLocalCartesian, kUndefined);
  add("Undefined geographic SRS", 0, "NONE", 0, kUndefined);
  add("WGS 84 geodetic", kWgs84, "EPSG", kWgs84, kWgs84Definition);

  const uint32_t code = metric_epsg_code(crs);
  const bool has_text = is_wkt1_of_map(crs);
  const std::string text = valid_utf8(crs);
  if (code != 0) {
    const std::string number = "EPSG:" + std::to_string(code);
    add(has_text ? name_in(text) : number, code, "EPSG", code, has_text ? text : kUndefined);
    return static_cast<int32_t>(code);
  }
  const LengthUnits units = units_of_crs(crs);
  if (!has_text || !units.known || !units.metres() || units.degrees) return kLocalCartesian;
  add(name_in(text), kFirstOfUsers, "NONE", kFirstOfUsers, text);
  return kFirstOfUsers;
}

}  // namespace jalon::gpkg
