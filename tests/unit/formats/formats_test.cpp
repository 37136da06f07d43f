// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Which format a file is read and written in: the option before the content before the name.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "formats/codecs/codecs.h"
#include "formats/formats.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

Model one_triangle() {
  Model model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  model.triangles = {{0, 1, 2}};
  model.triangle_faces = {0};
  return model;
}

Failure refusal_to_read(const std::string& name, const std::string& bytes) {
  const Folder folder;
  spill(folder.file(name), bytes);
  return failure_of([&] { read(folder.file(name)); });
}

}  // namespace

TEST_CASE(
    "formats__every_cloud_format_reads_back_what_it_wrote_under_any_name_when_it_is_asked_to") {
  const Folder folder;
  const Cloud cloud = random_points(20, 11);
  for (const char* format : {"las", "ply", "text", "csv"}) {
    CAPTURE(format);
    const std::string path = folder.file("named.obj");
    WriteSettings to;
    to.format = format;
    write(cloud, path, to);
    ReadSettings from;
    from.format = format == std::string("csv") ? "text" : format;
    const Cloud back = read(path, from);
    REQUIRE(back.size() == 20);
    for (size_t i = 0; i < 20; ++i)  // LAS rounds to half a step of 0.0001 m on each axis
      CHECK(norm(back.point(i) - cloud.point(i)) <= 0.00009);
  }
  for (const char* format : {"ply", "obj", "stl", "cityjson"}) {
    CAPTURE(format);
    const std::string path = folder.file("named.las");
    WriteSettings to;
    to.format = format;
    ReadSettings from;
    from.format = format;
    Task task;
    write_model(one_triangle(), path, to, task);
    const Model back = read_model(path, from, task);
    CHECK(back.triangles.size() + back.faces.size() == 1);
    CHECK(back.vertices.size() == 3);
  }
}

TEST_CASE("formats__an_extension_counts_in_any_case_and_only_in_the_last_part_of_the_path") {
  const Folder folder;
  Task task;
  write(random_points(3, 1), folder.file("A.LaS"));
  CHECK(slurp(folder.file("A.LaS")).starts_with("LASF"));
  write(random_points(3, 1), folder.file("a.obj.text"));  // a keyword is an extension too
  CHECK(read(folder.file("a.obj.text")).size() == 3);
  write_model(one_triangle(), folder.file("a.las.OBJ"), {}, task);
  CHECK(read_model(folder.file("a.las.OBJ"), {}, task).triangles.size() == 1);
  std::filesystem::create_directory(folder.file("scans.las"));
  const Failure failure =
      failure_of([&] { write(random_points(3, 1), folder.file("scans.las/first")); });
  CHECK(failure.status == Status::kUnsupported);
  CHECK(has_text(failure.text, "no format of extension \"\""));
  CHECK(folder.entries() == 4);
}

TEST_CASE("formats__text_and_models_without_a_mark_go_by_their_name") {
  const Folder folder;
  Task task;
  for (const char* name : {"a.obj", "a.OBJ"}) {
    spill(folder.file(name), kTriangle);
    CHECK(read_model(folder.file(name), {}, task).triangles.size() == 1);
  }
  spill(folder.file("points"), "1 2 3\n4 5 6\n");  // no name tells: it is plain text
  CHECK(read(folder.file("points")).size() == 2);
  spill(folder.file("points.csv"), "x,y,z\n1,2,3\n");
  CHECK(read(folder.file("points.csv")).size() == 1);
  ReadSettings as_text;
  as_text.format = "text";
  spill(folder.file("points.ply"), "1 2 3\n");
  CHECK(read(folder.file("points.ply"), as_text).size() == 1);
  const Failure named = failure_of([&] { read(folder.file("points.ply")); });
  CHECK(named.status == Status::kFormat);
  CHECK(has_text(named.text, "a PLY file starts with ply, this one does not"));
}

TEST_CASE("formats__what_cannot_be_read_is_refused_with_its_name_and_the_reason") {
  const Failure empty = refusal_to_read("a.las", "");
  CHECK(empty.status == Status::kFormat);
  CHECK(has_text(empty.text, "a.las: offset 0: the file is empty"));
  CHECK(refusal_to_read("a.xyz", kTriangle).status == Status::kFormat);
  CHECK(refusal_to_read("a.obj", kTriangle).status == Status::kUnsupported);
  CHECK(refusal_to_read("a.xyz", "ASTM-E57").status ==  // whatever its name
        (has_codecs() ? Status::kFormat : Status::kUnsupported));
  const Failure missing = failure_of([] { read("/nowhere/a.las"); });
  CHECK(missing.status == Status::kNotFound);
  CHECK(has_text(missing.text, "/nowhere/a.las"));
  const Folder folder;
  WriteSettings as_model;
  as_model.format = "obj";
  CHECK(failure_of([&] { write(random_points(3, 1), folder.file("a"), as_model); }).status ==
        Status::kUnsupported);
  CHECK(folder.entries() == 0);
}

TEST_CASE("formats__where_the_option_names_a_format_that_cannot_do_it_the_option_is_to_blame") {
  const Folder folder;
  const auto says = [&](const Failure& failure, const std::string& words) {
    CHECK(failure.status == Status::kUnsupported);
    CHECK_MESSAGE(has_text(failure.text, folder.file("a.las") + ": " + words), failure.text);
  };
  Task task;
  WriteSettings to;
  to.format = "obj";
  says(failure_of([&] { write(random_points(3, 1), folder.file("a.las"), to); }),
       "no cloud can be written in format \"obj\", which the option \"format\" names; there are: "
       "copc, laz, e57, las, ply, pcd, png, tif, ept, pts, text, csv");
  to.format = "csv";
  says(failure_of([&] { write_model(one_triangle(), folder.file("a.las"), to, task); }),
       "no model can be written in format \"csv\", which the option \"format\" names; there are: "
       "ply, obj, stl, cityjson, dxf, geojson, glb, ifc, gpkg");
  CHECK(folder.entries() == 0);
  write(random_points(3, 1), folder.file("a.las"));
  ReadSettings from;
  from.format = "obj";
  says(failure_of([&] { read(folder.file("a.las"), from); }),
       "no cloud can be read in format \"obj\", which the option \"format\" names; there are: "
       "copc, laz, e57, las, ply, pcd, png, ept, ptx, pts, text");
  from.format = "las";
  says(failure_of([&] { read_model(folder.file("a.las"), from, task); }),
       "no model can be read in format \"las\", which the option \"format\" names; there are: "
       "ply, obj, stl, cityjson");
}

TEST_CASE("formats__a_box_leaves_the_points_inside_of_any_cloud") {
  const Folder folder;
  spill(folder.file("a.xyz"), "1 1 1\n2 2 2\n3 3 3\n");
  ReadSettings settings;
  settings.box = {1.5, 0, 0, 3, 3, 3};
  const Cloud cloud = read(folder.file("a.xyz"), settings);
  REQUIRE(cloud.size() == 2);
  CHECK(cloud.point(1).x == 3);
  settings.unit = FileUnit::kMillimetres;  // the box is in metres
  settings.box = {0.0015, 0, 0, 0.0025, 1, 1};
  CHECK(read(folder.file("a.xyz"), settings).size() == 1);
  for (const std::vector<double>& bad : std::vector<std::vector<double>>{
           {1, 2, 3}, {1, 0, 0, 0, 1, 1}, {0, 0, 0, 1, 1, std::nan("")}}) {
    settings.box = bad;
    const Failure failure = failure_of([&] { read(folder.file("a.xyz"), settings); });
    CHECK(failure.status == Status::kInvalidArgument);
    CHECK(has_text(failure.text, "\"box\""));
  }
}

TEST_CASE("formats__what_has_no_levels_and_what_is_no_cloud_refuses_the_options_of_a_part") {
  const Folder folder;
  spill(folder.file("a.xyz"), "1 1 1\n");
  spill(folder.file("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ReadSettings settings;
  settings.spacing_m = 0.1;
  Failure failure = failure_of([&] { read(folder.file("a.xyz"), settings); });
  CHECK(failure.status == Status::kUnsupported);
  CHECK(has_text(failure.text, "COPC"));
  Task task;
  failure = failure_of([&] { read_model(folder.file("a.obj"), settings, task); });
  CHECK(failure.status == Status::kUnsupported);
  CHECK(has_text(failure.text, "are of clouds"));
}
