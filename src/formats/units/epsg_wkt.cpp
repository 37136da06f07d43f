// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/units/epsg_wkt.h"

#include <cmath>
#include <initializer_list>

#include "base/text_number.h"

namespace jalon {

namespace {

struct DatumText {
  const char *system, *datum, *spheroid;
  double flattening;  ///< its inverse
  uint32_t spheroid_code, datum_code, system_code;
};

// EPSG dataset: geodetic datums and their ellipsoids, the names as those of WKT 1.
constexpr double kWgs84Flattening = 298.257223563, kGrs80Flattening = 298.257222101;
constexpr DatumText kOfWgs84{"WGS 84", "WGS_1984", "WGS 84", kWgs84Flattening, 7030, 6326, 4326};
constexpr DatumText kOfEtrs89{"ETRS89",   "European_Terrestrial_Reference_System_1989",
                              "GRS 1980", kGrs80Flattening,
                              7019,       6258,
                              4258};
constexpr DatumText kOfRgf93{
    "RGF93 v1", "Reseau_Geodesique_Francais_1993_v1", "GRS 1980", kGrs80Flattening, 7019, 6171,
    4171};

std::string authority(uint32_t code) {
  return ",AUTHORITY[\"EPSG\",\"" + std::to_string(code) + "\"]]";
}

// Without an exponent, which readers of WKT may not know.
std::string plain_number(double value) {
  return value == std::floor(value) ? std::to_string(static_cast<int64_t>(value)) : text_of(value);
}

struct Parameter {
  const char* name;
  double value;
};

std::string projected_wkt(const std::string& name, const DatumText& datum, const char* projection,
                          std::initializer_list<Parameter> parameters, uint32_t code) {
  std::string out = "PROJCS[\"" + name + "\",GEOGCS[\"" + datum.system + "\",DATUM[\"" +
                    datum.datum + "\",SPHEROID[\"" + datum.spheroid + "\",6378137," +
                    text_of(datum.flattening) + authority(datum.spheroid_code) +
                    authority(datum.datum_code) + ",PRIMEM[\"Greenwich\",0" + authority(8901) +
                    ",UNIT[\"degree\",0.0174532925199433" + authority(9122) +
                    authority(datum.system_code) + ",PROJECTION[\"" + projection + "\"]";
  for (const auto& [key, value] : parameters)
    out += ",PARAMETER[\"" + std::string(key) + "\"," + plain_number(value) + "]";
  return out + ",UNIT[\"metre\",1" + authority(9001) +
         ",AXIS[\"Easting\",EAST],AXIS[\"Northing\",NORTH]" + authority(code);
}

std::string utm_wkt(const DatumText& datum, uint32_t zone, bool is_south, uint32_t code) {
  return projected_wkt(
      std::string(datum.system) + " / UTM zone " + std::to_string(zone) + (is_south ? "S" : "N"),
      datum, "Transverse_Mercator",
      {{"latitude_of_origin", 0},
       {"central_meridian", 6.0 * zone - 183},
       {"scale_factor", 0.9996},
       {"false_easting", 500000},
       {"false_northing", is_south ? 10000000.0 : 0.0}},
      code);
}

std::string conic_wkt(const char* name, double latitude, double half_width, double easting,
                      double northing, uint32_t code) {
  return projected_wkt(std::string(kOfRgf93.system) + " / " + name, kOfRgf93,
                       "Lambert_Conformal_Conic_2SP",
                       {{"latitude_of_origin", latitude},
                        {"central_meridian", 3},
                        {"standard_parallel_1", latitude + half_width},
                        {"standard_parallel_2", latitude - half_width},
                        {"false_easting", easting},
                        {"false_northing", northing}},
                       code);
}

}  // namespace

std::string wkt_of_epsg(uint32_t code) {
  if (code > 32600 && code <= 32660) return utm_wkt(kOfWgs84, code - 32600, false, code);
  if (code > 32700 && code <= 32760) return utm_wkt(kOfWgs84, code - 32700, true, code);
  if (code >= 25828 && code <= 25837) return utm_wkt(kOfEtrs89, code - 25800, false, code);
  if (code == 2154) return conic_wkt("Lambert-93", 46.5, 2.5, 700000, 6600000, code);
  if (code >= 3942 && code <= 3950) {
    const uint32_t zone = code - 3900;
    const std::string name = "CC" + std::to_string(zone);
    return conic_wkt(name.c_str(), zone, 0.75, 1700000, (zone - 41.0) * 1000000 + 200000, code);
  }
  return "";
}

}  // namespace jalon
