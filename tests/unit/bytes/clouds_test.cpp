// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/clouds.h"

#include <doctest/doctest.h>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

Cloud cloud_with_stations() {
  Cloud cloud = test::cloud_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  cloud.stations = {{"A", true, Transform(), 0, 2}, {"B", false, Transform(), 2, 1}};
  cloud.attachments = std::make_shared<const std::vector<Attachment>>(
      std::vector<Attachment>{{"las:vlr", {std::byte{1}, std::byte{0}, std::byte{255}}}});
  return cloud;
}

std::string cloud_read_back(const Cloud& cloud, Cloud& out) {
  Task task;
  ByteWriter writer;
  write_cloud(writer, cloud);
  const Buffer<uint8_t> whole = writer.sealed(BytesKind::kCloud, task);
  try {
    ByteReader reader({whole.data(), whole.size()}, BytesKind::kCloud, task);
    out = read_cloud(reader, task);
    reader.end();
  } catch (const Error& error) {
    CHECK(error.status() == Status::kFormat);
    return error.what();
  }
  return "";
}

TEST_CASE("cloud_bytes__carry_what_file_formats_want_back") {
  Cloud back;
  CHECK(cloud_read_back(cloud_with_stations(), back) == "");
  REQUIRE(back.attachments != nullptr);
  CHECK(back.attachments->at(0).key == "las:vlr");
  CHECK(back.attachments->at(0).bytes == cloud_with_stations().attachments->at(0).bytes);
  CHECK(back.stations[1].first == 2);
  Cloud bare = cloud_with_stations();
  bare.attachments = nullptr;
  CHECK(cloud_read_back(bare, back) == "");
  CHECK(back.attachments == nullptr);
}

TEST_CASE("cloud_bytes__that_break_a_promise_of_clouds_are_refused") {
  Cloud back, cloud = cloud_with_stations();
  cloud.stations[1].count = 2;  // beyond the points
  CHECK(cloud_read_back(cloud, back) != "");
  cloud = cloud_with_stations();
  cloud.stations[1].first = 1;  // of A already
  CHECK(cloud_read_back(cloud, back) != "");
  cloud = cloud_with_stations();
  for (const auto& [i, value] : {std::pair{3, NAN}, {0, 0.0}, {0, 2.0}, {10, -1.0}}) {
    cloud = cloud_with_stations();
    cloud.stations[0].pose.m[static_cast<size_t>(i)] = value;
    CHECK(cloud_read_back(cloud, back).find("the pose of a station is no rigid motion") !=
          std::string::npos);
  }
  CHECK(cloud_read_back(test::cloud_of({{0, INFINITY, 0}}), back).find("not finite") !=
        std::string::npos);
  cloud = cloud_with_stations();
  cloud.fields.set(make_column<float>({"short"}, std::vector<float>{1, 2}));
  CHECK(cloud_read_back(cloud, back).find("2 rows where there must be 3") != std::string::npos);
}

}  // namespace
}  // namespace jalon
