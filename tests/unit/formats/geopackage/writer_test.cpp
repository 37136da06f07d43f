// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The rows of a file as SQLite reads them; GDAL reads the same house in tests/formats.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>

#include "formats/files/endian.h"
#include "formats/geopackage/sqlite_database.h"
#include "unit/formats/geopackage/opened_package.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("gpkg_writer__the_file_is_a_geopackage_of_version_1_3") {
  if (!has_sqlite()) return;
  const std::string bytes = OpenedPackage({}).bytes();
  CHECK(bytes.starts_with("SQLite format 3"));
  CHECK(bytes.substr(68, 4) == "GPKG");
  CHECK((load<uint32_t, std::endian::big>(bytes.data() + 60)) == 10300);
}

TEST_CASE("gpkg_writer__faces_tell_their_part_measures_and_precision") {
  if (!has_sqlite()) return;
  const Model model = House().model();
  const OpenedPackage package(model);
  CHECK(package.value("SELECT count(*) FROM faces") == std::to_string(model.faces.size()));
  CHECK(package.rows("SELECT name, part_of, facade, evidence, copied, width_m FROM faces WHERE "
                     "class = 'wall'") ==
        Rows{{"wall \xC3\xA9t\xC3\xA9", "facade A", "facade A", "none", "0", "-"}});
  CHECK(std::stod(package.value("SELECT sigma_m FROM faces WHERE class = 'joinery'")) == 0.002);
  CHECK(std::abs(std::stod(package.value("SELECT area_m2 FROM faces WHERE class = 'wall'")) -
                 House::wall_area()) < 1e-9);
  // Outline and four holes, of which arcs have become chords.
  const std::string wall = package.value("SELECT geom FROM faces WHERE class = 'wall'");
  CHECK(load<uint32_t>(wall.data() + 45) == 5);
  CHECK(wall.size() > 40 + 4 + 5 * 5 * 24);
}

TEST_CASE("gpkg_writer__openings_are_features_with_what_is_known_of_them") {
  if (!has_sqlite()) return;
  const OpenedPackage package(House().model());
  CHECK(package.rows("SELECT class, name, evidence, copied, copied_from, height_m FROM openings "
                     "ORDER BY name") ==
        Rows{{"door", "door", "seen_behind", "0", "-", "-"},
             {"opening", "round", "shape", "0", "-", "-"},
             {"window", "window 1", "revealed", "0", "-", "2.1"},
             {"window", "window 2", "copied", "1", "window 1", "-"}});
}

TEST_CASE("gpkg_writer__the_elevation_is_unrolled_from_the_left_end_with_openings_behind") {
  if (!has_sqlite()) return;
  const OpenedPackage package(House().model());
  const Rows rows = package.rows("SELECT kind, class, facade FROM elevation ORDER BY fid");
  REQUIRE(rows.size() > 5);
  for (size_t i = 0; i < rows.size(); ++i) CHECK((rows[i][0] == "opening") == (i < 4));
  const auto place = [&](const char* part_class) {
    return std::ranges::find(rows, part_class, [](const auto& row) { return row[1]; }) -
           rows.begin();
  };
  CHECK(place("joinery") < place("wall"));
  CHECK(place("wall") < place("no_data"));  // 1 mm before it
  const Rows box =
      package.rows("SELECT min_x, max_x, min_y FROM gpkg_contents WHERE table_name = 'elevation'");
  CHECK(std::abs(std::stod(box[0][0])) < 1e-8);
  CHECK(std::abs(std::stod(box[0][1]) - 12) < 1e-8);
  CHECK(std::abs(std::stod(box[0][2]) - 142.5) < 1e-8);
}

TEST_CASE("gpkg_writer__the_plan_has_the_wall_between_its_openings") {
  if (!has_sqlite()) return;
  WriteSettings settings;
  settings.gpkg_plan_height_m = 1.2;
  const OpenedPackage package(House().model(), settings);
  const auto total = [&](const char* where) {
    return std::stod(package.value(std::string("SELECT sum(length_m) FROM plan WHERE ") + where));
  };
  CHECK(std::abs(total("class = 'wall'") - (12 - 1.2 - 1 - 1.2)) < 1e-6);
  CHECK(std::abs(total("kind = 'opening' AND class = 'door'") - 1) < 1e-6);
  CHECK(std::abs(total("kind = 'opening' AND class = 'window'") - 2.4) < 1e-6);
  CHECK(std::abs(total("class = 'joinery'") - 1.2) < 1e-6);
  CHECK(package.value("SELECT count(*) FROM plan WHERE class = 'roof'") == "0");
}

TEST_CASE("gpkg_writer__triangles_of_no_face_are_a_layer_of_their_own") {
  if (!has_sqlite()) return;
  Model model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  model.triangles = {{0, 1, 2}, {1, 3, 2}};
  model.triangle_faces = {5, 6};
  const OpenedPackage package(model);
  CHECK(package.rows("SELECT face, class FROM mesh") == Rows{{"5", "-"}, {"6", "-"}});
  CHECK(package.value(
            "SELECT geometry_type_name FROM gpkg_geometry_columns WHERE table_name = 'mesh'") ==
        "MULTIPOLYGON");
}

TEST_CASE("gpkg_writer__equal_models_give_equal_bytes_and_hostile_names_are_texts") {
  if (!has_sqlite()) return;
  Model model = House().model();
  model.parts[2].name = "x'); DROP TABLE faces; --\xFF";
  const OpenedPackage a(model), b(model);
  CHECK(a.bytes() == b.bytes());
  CHECK(a.value("SELECT name FROM faces WHERE class = 'wall'") ==
        "x'); DROP TABLE faces; --\xEF\xBF\xBD");
}

TEST_CASE("gpkg_writer__a_missing_place_a_full_disk_and_a_cancelled_write_leave_nothing_new") {
  if (!has_sqlite()) return;
  const Folder folder;
  const std::string target = folder.file("a.gpkg");
  spill(target, "good");
  {
    Task task;
    CHECK(failure_of([&] { write_geopackage({}, folder.file("no/a.gpkg"), {}, task); }).status ==
          Status::kIo);
  }
  std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task cancelled(hooks);
  const Model model = House().model();
  CHECK(failure_of([&] { write_geopackage(model, target, {}, cancelled); }).status ==
        Status::kCancelled);
  // A limit on the size of files stands in for the full disk; it is the child's own.
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{10000, 10000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    Task task;
    ::_exit(failure_of([&] { write_geopackage(model, target, {}, task); }).status == Status::kIo
                ? 0
                : 1);
  }
  int state = 0;
  ::waitpid(child, &state, 0);
  CHECK(state == 0);
  CHECK(slurp(target) == "good");
  CHECK(folder.entries() == 1);
}
