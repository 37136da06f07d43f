// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// From file to file, to the bytes of reading and writing. capi/io_test.c looks at the memory.
#include <doctest/doctest.h>

#include "formats/codecs/codecs.h"
#include "unit/formats/stations_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

uint64_t convert(const Folder& folder, const char* from, const char* to,
                 const ConvertSettings& settings = {}) {
  Task task;
  return convert_cloud(folder.file(from), folder.file(to), settings, task);
}

void check_as_read_and_written(const Folder& folder, const char* from, const std::string& extension,
                               const ConvertSettings& settings = {}) {
  const std::string streamed = "streamed." + extension, whole = "whole." + extension;
  const Cloud cloud = read(folder.file(from), settings.reading);
  write(cloud, folder.file(whole), settings.writing);
  CHECK(convert(folder, from, streamed.c_str(), settings) == cloud.size());
  CHECK(slurp(folder.file(streamed)) == slurp(folder.file(whole)));
}

}  // namespace

TEST_CASE("convert__gives_the_bytes_of_reading_and_writing") {
  const Folder folder;
  Cloud cloud = random_points(5000, 4);
  RandomStream random(4, 2);
  cloud.fields.set(random_column("intensity", ElementType::kUint16, 1, 5000, random));
  cloud.fields.set(random_column("own", ElementType::kFloat64, 1, 5000, random));
  write(cloud, folder.file("a.las"));
  for (const char* extension : {"las", "xyz", "csv", "pts", "ply", "pcd"})
    check_as_read_and_written(folder, "a.las", extension);
  write(cloud, folder.file("a.xyz"));
  check_as_read_and_written(folder, "a.xyz", "las");
  if (!has_codecs()) return;
  write(cloud, folder.file("a.laz"));
  write(cloud, folder.file("a.copc.laz"));
  for (const char* from : {"a.las", "a.laz", "a.copc.laz"})
    for (const char* extension : {"las", "laz", "copc.laz"})
      check_as_read_and_written(folder, from, extension);
}

TEST_CASE("convert__of_several_pieces_gives_the_bytes_of_the_whole") {
  const Folder folder;
  write(random_points((size_t{1} << 20) + 1000, 8), folder.file("large.las"));
  check_as_read_and_written(folder, "large.las", has_codecs() ? "laz" : "las");
  ConvertSettings box;  // a corner of the points: a part of each piece
  box.reading.box = {651975, 6860975, 75, 651990, 6861025, 125};
  check_as_read_and_written(folder, "large.las", "las", box);
  box.reading.box = {0, 0, 0, 1, 1, 1};
  check_as_read_and_written(folder, "large.las", "las", box);
  ConvertSettings thin;
  thin.reading.max_points = 1500;
  thin.reading.fields = "classification";
  check_as_read_and_written(folder, "large.las", "las", thin);
  thin.reading.box = box.reading.box;
  check_as_read_and_written(folder, "large.las", "xyz", thin);
  ConvertSettings steps;  // that the first piece cannot settle
  steps.writing.scale = 0.01;
  check_as_read_and_written(folder, "large.las", "las", steps);
}

TEST_CASE("convert__keeps_the_stations_of_all_formats_that_tell_them") {
  const Folder folder;
  const Cloud cloud = two_stations();
  write(cloud, folder.file("a.las"));
  write(cloud, folder.file("beside.xyz"));
  convert(folder, "a.las", "b.las");
  check_same_stations(read(folder.file("b.las")), cloud);
  convert(folder, "beside.xyz", "c.las");
  check_same_stations(read(folder.file("c.las")), cloud);
  convert(folder, "a.las", "d.xyz");
  check_same_stations(read(folder.file("d.xyz")), cloud);
}

TEST_CASE("convert__takes_away_the_stations_that_an_earlier_file_of_the_name_left") {
  const Folder folder;
  write(two_stations(), folder.file("b.xyz"));
  write(random_points(20, 5), folder.file("a.las"));
  convert(folder, "a.las", "b.xyz");
  CHECK(read(folder.file("b.xyz")).stations.empty());
  CHECK(folder.entries() == 2);
}

TEST_CASE("convert__of_a_file_over_itself_is_the_file") {
  const Folder folder;
  write(random_points(1000, 5), folder.file("a.las"));
  convert(folder, "a.las", "b.las");
  convert(folder, "b.las", "b.las");
  CHECK(slurp(folder.file("b.las")) == slurp(folder.file("a.las")));
}

TEST_CASE("convert__names_the_file_that_is_wrong_and_leaves_none") {
  const Folder folder;
  CHECK(failure_of([&] { convert(folder, "none.las", "b.las"); }).status == Status::kNotFound);
  spill(folder.file("cut.las"), "LASF");
  const Failure cut = failure_of([&] { convert(folder, "cut.las", "b.las"); });
  CHECK(cut.status == Status::kFormat);
  CHECK(cut.text.find("cut.las") != std::string::npos);
  CHECK(folder.entries() == 1);
}
