// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// CRS records of LAS files: there and back, and the words of GeoTIFF 1.8.2 written out by hand.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "formats/las/layout.h"
#include "formats/units/epsg_wkt.h"
#include "unit/formats/las/las_bytes.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr const char* kProjection = "LASF_Projection";
constexpr const char* kMetricWkt = "PROJCS[\"p\",UNIT[\"metre\",1]]";

las::Record words_record(uint16_t id, const std::vector<uint16_t>& words) {
  std::string data;
  for (const uint16_t word : words) put_at(data, data.size(), word);
  return las::make_record(kProjection, id, "", data.data(), data.size());
}

// The directory of these keys: (key, location, count, value) each.
las::Record directory_of(std::vector<uint16_t> entries) {
  entries.insert(entries.begin(), {1, 1, 0, static_cast<uint16_t>(entries.size() / 4)});
  return words_record(34735, entries);
}

las::Record wkt_text_record(const std::string& text) {
  return las::make_record(kProjection, 2112, "", text.c_str(), text.size() + 1);
}

las::Record doubles_record(const std::vector<double>& values) {
  std::string data;
  for (const double value : values) put_at(data, data.size(), value);
  return las::make_record(kProjection, 34736, "", data.data(), data.size());
}

}  // namespace

TEST_CASE("las_crs__every_text_comes_back_as_it_was_from_the_records_that_say_it") {
  for (const char* text :
       {"EPSG:2154", "EPSG:4326", "EPSG:32766", "EPSG:32767", "EPSG:102100", "EPSG:0", "epsg:2154",
        "EPSG:02154", "urn:ogc:def:crs:EPSG::2154", "site grid \xC3\xA9t\xC3\xA9", kMetricWkt}) {
    CAPTURE(text);
    const std::vector<las::Record> records = las::crs_records(text);
    REQUIRE(records.size() == 1);
    CHECK(las::is_crs_record(records[0]));
    CHECK(las::crs_text(records, {}) == text);
    CHECK(las::crs_text({}, records) == text);
  }
  CHECK(las::crs_records("").empty());
  CHECK(las::crs_text({}, {}).empty());
  CHECK_FALSE(las::is_crs_record(extra_bytes_record({})));
}

TEST_CASE("las_crs__epsg_codes_become_the_keys_that_other_programs_read") {
  const auto words_of = [](const char* crs) {
    const las::Record record = las::crs_records(crs)[0];
    CHECK(record.is(kProjection, 34735));
    std::vector<uint16_t> words;
    for (size_t i = 0; i + 2 <= record.size(); i += 2)
      words.push_back(load<uint16_t>(record.data() + i));
    return words;
  };
  // GTModelTypeGeoKey: 1 projected, 2 geographic; then ProjectedCSTypeGeoKey or GeographicTypeGeoKey.
  CHECK(words_of("EPSG:2154") ==
        std::vector<uint16_t>{1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 2154});
  CHECK(words_of("EPSG:4326") ==
        std::vector<uint16_t>{1, 1, 0, 2, 1024, 0, 1, 2, 2048, 0, 1, 4326});
}

TEST_CASE("las_crs__a_text_goes_before_keys_and_keys_that_say_nothing_give_no_crs") {
  const las::Record keys = directory_of({1024, 0, 1, 1, 3072, 0, 1, 2154});
  const las::Record own = las::crs_records("site grid")[0];
  CHECK(las::crs_text({keys, wkt_text_record(kMetricWkt)}, {}) == kMetricWkt);
  // The text of the keys' own code, as COPC has it, says no more; of another it does.
  CHECK(las::crs_text({keys, wkt_text_record(wkt_of_epsg(2154))}, {}) == "EPSG:2154");
  CHECK(las::crs_text({keys, wkt_text_record(wkt_of_epsg(3946))}, {}) == wkt_of_epsg(3946));
  CHECK(las::crs_text({wkt_text_record(wkt_of_epsg(2154))}, {}) == wkt_of_epsg(2154));
  CHECK(las::crs_text({keys, wkt_text_record("")}, {}) == "EPSG:2154");
  CHECK(las::crs_text({keys}, {wkt_text_record(kMetricWkt)}) == kMetricWkt);
  CHECK(las::crs_text({keys, wkt_text_record(kMetricWkt), own}, {}) == "site grid");
  CHECK(las::crs_text({directory_of({3072, 0, 1, 32767})}, {}).empty());  // user-defined
  CHECK(las::crs_text({directory_of({3072, 34736, 1, 0})}, {}).empty());  // no short number
  CHECK(las::crs_text({directory_of({3072, 0, 1, 32767, 2048, 0, 1, 4171})}, {}) == "EPSG:4171");
  CHECK(las::crs_text({words_record(34735, {1, 1, 0})}, {}).empty());  // cut in its header
  CHECK(las::crs_text({words_record(34735, {1, 1, 0, 9, 3072, 0, 1})}, {}).empty());  // in a key
}

TEST_CASE("las_crs__a_unit_of_the_files_own_has_the_size_that_the_record_of_doubles_says") {
  const auto unit = [](uint16_t place, const std::vector<double>& doubles) {
    return las::units_of(
        {directory_of({3076, 0, 1, 32767, 3077, 34736, 1, place}), doubles_record(doubles)}, {},
        "a.las");
  };
  CHECK(unit(1, {9, 0.2011684}).horizontal == 0.2011684);  // a link
  CHECK(unit(1, {9, 0.2011684}).vertical == 0.2011684);
  for (const std::vector<double>& doubles :
       {std::vector<double>{9}, std::vector<double>{9, -1}, std::vector<double>{9, 0}}) {
    const Failure failure = failure_of([&] { unit(1, doubles); });
    CHECK(failure.status == Status::kUnsupported);
    CHECK(has_text(failure.text, "a.las: "));
    CHECK(has_text(failure.text, "unit 32767"));
  }
  CHECK(las::units_of(las::crs_records("EPSG:2263"), {}, "a").horizontal ==
        doctest::Approx(1200.0 / 3937.0).epsilon(1e-12));
}
