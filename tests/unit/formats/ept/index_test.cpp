// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/index.h"

#include "unit/formats/ept/ept_files.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string index_of(const std::string& schema, const std::string& more = "") {
  return "{\"bounds\":[0,0,0,8,8,8],\"dataType\":\"binary\",\"hierarchyType\":\"json\",\"span\":"
         "16" +
         more + ",\"schema\":[" + schema + "]}";
}

constexpr const char* kXyz =
    "{\"name\":\"X\",\"type\":\"signed\",\"size\":4,\"scale\":0.01,\"offset\":5},"
    "{\"name\":\"Y\",\"type\":\"float\",\"size\":8},{\"name\":\"Z\",\"type\":\"signed\",\"size\":"
    "8}";

ept::Index read_text(const std::string& text) {
  Task task;
  return ept::read_index(OpenedFile(text, "ept.json"), task);
}

}  // namespace

TEST_CASE("ept_index__dimensions_of_other_makers_get_their_places_and_our_names") {
  const ept::Index index =
      read_text(index_of(std::string("{\"name\":\"GpsTime\",\"type\":\"float\",\"size\":8},") +
                             kXyz + ",{\"name\":\"Red\",\"type\":\"unsigned\",\"size\":2}",
                         ",\"srs\":{\"authority\":\"EPSG\",\"horizontal\":\"2154\"}"));
  CHECK(index.spacing == 0.5);
  CHECK(index.axes[0].offset == 8);
  CHECK(index.axes[0].scale == 0.01);
  CHECK(index.axes[0].shift == 5);
  CHECK(index.axes[1].type == ElementType::kFloat64);
  CHECK(index.record_bytes == 30);
  REQUIRE(index.members.size() == 2);
  CHECK(index.members[0].field == "gps_time");
  CHECK(index.members[1].field == "red");
  CHECK(index.members[1].offset == 28);
  CHECK(index.crs == "EPSG:2154");
}

TEST_CASE("ept_index__what_cannot_be_is_refused_and_what_is_compressed_is_named") {
  const auto refusal = [](const std::string& text) { return failure_of([&] { read_text(text); }); };
  std::string laszip = index_of(kXyz);
  laszip.replace(laszip.find("binary"), 6, "laszip");
  CHECK(refusal(laszip).status == Status::kUnsupported);
  CHECK(has_text(refusal(laszip).text, "laszip"));
  for (const std::string& bad :
       {std::string("{"), std::string("[]"), std::string("{}"), index_of(""),
        index_of(std::string(kXyz) + ",{\"name\":\"A\",\"type\":\"signed\",\"size\":3}"),
        index_of(std::string(kXyz) + ",{\"name\":\"A\",\"type\":\"float\",\"size\":2}"),
        index_of(std::string(kXyz) + ",7"), index_of(kXyz, ",\"bounds\":[1,2,3]"),
        index_of(kXyz, ",\"bounds\":[0,0,0,0,0,0]"), index_of(kXyz, ",\"span\":0")}) {
    CAPTURE(bad);
    CHECK(refusal(bad).status == Status::kFormat);
    CHECK(has_text(refusal(bad).text, "ept.json: offset "));
  }
}
