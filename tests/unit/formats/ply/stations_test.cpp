// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "unit/formats/kept_log.h"
#include "unit/formats/stations_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("ply_stations__come_back_from_the_comments") {
  const Folder folder;
  const Cloud cloud = two_stations(true);
  for (const PlyForm form : {PlyForm::kAscii, PlyForm::kBigEndian, PlyForm::kLittleEndian}) {
    WriteSettings settings;
    settings.ply_format = form;
    write(cloud, folder.file("a.ply"), settings);
    check_same_stations(read(folder.file("a.ply")), cloud);
  }
  CHECK(folder.entries() == 1);
}

TEST_CASE("ply_stations__in_another_unit_are_scaled_with_the_points") {
  const Folder folder;
  const Cloud cloud = two_stations();
  write(cloud, folder.file("a.ply"));
  ReadSettings settings;
  settings.unit = FileUnit::kMillimetres;
  CHECK(read(folder.file("a.ply"), settings).stations[0].pose.m[3] == doctest::Approx(1.00025));
}

TEST_CASE("ply_stations__of_comments_that_fit_no_more_are_left_out_with_a_warning") {
  const Folder folder;
  WriteSettings settings;
  settings.ply_format = PlyForm::kAscii;
  write(two_stations(), folder.file("a.ply"), settings);
  std::string text = slurp(folder.file("a.ply"));
  text.replace(text.find("vertex 20"), 9, "vertex 19");
  spill(folder.file("a.ply"), text);
  KeptLog log;
  CHECK(read_cloud(folder.file("a.ply"), {}, log.task()).stations.empty());
  CHECK(log.warnings().size() == 1);
}
