// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// WKT of the systems that the library can name itself; whether PROJ takes them for the same is asked where pyproj is
// (tests/fuzz/check_copc.py).
#include "formats/units/epsg_wkt.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "formats/units/crs_code.h"
#include "formats/units/length_units.h"

using namespace jalon;

TEST_CASE("epsg_wkt__each_text_bears_its_code_is_in_metres_and_its_brackets_close") {
  size_t known = 0;
  for (uint32_t code = 0; code < 40000; ++code) {
    const std::string wkt = wkt_of_epsg(code);
    if (wkt.empty()) continue;
    ++known;
    CAPTURE(wkt);
    CHECK(wkt_epsg_code(wkt) == code);
    CHECK(metric_epsg_code(wkt) == code);
    CHECK(units_of_crs(wkt).known);
    CHECK(units_of_crs(wkt).metres());
    CHECK(!units_of_crs(wkt).degrees);
    CHECK(std::ranges::count(wkt, '[') == std::ranges::count(wkt, ']'));
    CHECK(std::ranges::count(wkt, '"') % 2 == 0);
  }
  CHECK(known == 60 + 60 + 10 + 1 + 9);
}

TEST_CASE("epsg_wkt__parameters_are_those_of_the_dataset") {
  const auto holds = [](uint32_t code, const char* text) {
    return wkt_of_epsg(code).find(text) != std::string::npos;
  };
  CHECK(holds(32631, "\"WGS 84 / UTM zone 31N\""));
  CHECK(holds(32631, "\"central_meridian\",3]"));
  CHECK(holds(32701, "\"central_meridian\",-177]"));
  CHECK(holds(32701, "\"false_northing\",10000000]"));
  CHECK(holds(25832, "\"central_meridian\",9]"));
  CHECK(holds(2154, "\"standard_parallel_1\",49]"));
  CHECK(holds(2154, "\"standard_parallel_2\",44]"));
  CHECK(holds(3950, "\"standard_parallel_1\",50.75]"));
  CHECK(holds(3942, "\"false_northing\",1200000]"));
  for (const uint32_t other : {0u, 4326u, 4978u, 25827u, 25838u, 32600u, 32661u, 32700u, 32761u})
    CHECK(wkt_of_epsg(other).empty());
}
