// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/registry.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/setting_rows.h"
#include "formats/codecs/codecs.h"
#include "formats/geopackage/sqlite_database.h"
#include "formats/png/grey_file.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string refusal(const std::string& name, const std::string& bytes, bool of_a_model) {
  const Folder folder;
  const std::string path = folder.file(name);
  spill(path, bytes);
  Task task;
  const Failure failure = failure_of(
      [&] { of_a_model ? void(read_model(path, {}, task)) : void(read_cloud(path, {}, task)); });
  CHECK(failure.status == Status::kUnsupported);
  REQUIRE(failure.text.starts_with(path + ": "));
  return failure.text.substr(path.size() + 2);
}

std::string refusal_to_write(const std::string& name, bool model) {
  const Folder folder;
  Task task;
  const Failure failure = failure_of([&] {
    model ? write_model({}, folder.file(name), {}, task)
          : write_cloud({}, folder.file(name), {}, task);
  });
  CHECK(failure.status == Status::kUnsupported);
  return failure.text.substr(failure.text.find(": ") + 2);
}

}  // namespace

TEST_CASE("registry__choices_of_the_options_are_the_formats_that_have_the_function") {
  CHECK(std::string(read_rows()[0].choices) ==
        "auto|copc|laz|e57|las|ply|pcd|png|ept|ptx|pts|text|obj|stl|cityjson|dxf");
  CHECK(
      std::string(write_rows()[0].choices) ==
      "auto|copc|laz|e57|las|ply|pcd|png|tif|ept|pts|text|csv|obj|stl|cityjson|dxf|geojson|glb|ifc|"
      "gpkg");
}

TEST_CASE("registry__every_choice_reads_or_writes_something") {
  Task task;
  const Folder folder;
  for (const Format& format : kFormats) {
    if (format.component == kCodecs && !has_codecs()) continue;
    if (format.component == kSqlite && !has_sqlite()) continue;
    if (format.component == kLibpng && !png::has_libpng()) continue;
    CAPTURE(format.name);
    WriteSettings settings;
    settings.format = format.keyword;
    const std::string path =
        folder.file(format.name == std::string("EPT") ? "ept.json" : "file_without_extension");
    if (format.write_model != nullptr) CHECK_NOTHROW(write_model({}, path, settings, task));
    if (format.write_cloud != nullptr)
      CHECK_NOTHROW(write_cloud(random_points(3, 1), path, settings, task));
  }
}

TEST_CASE("registry__abilities_follow_from_the_functions") {
  std::vector<std::string> lines;
  for (const FormatInfo& info : formats())
    lines.push_back(std::string(info.name) + ": " + info.extensions + ": " + info.abilities);
  const std::string optional = has_codecs() ? "cloud read write" : "";
  CHECK(lines == std::vector<std::string>{
                     "COPC: copc.laz: " + optional,
                     "LAZ: laz: " + optional,
                     "E57: e57: " + optional,
                     "LAS: las: cloud read write",
                     "PLY: ply: cloud read write, model read write",
                     "PCD: pcd: cloud read write",
                     std::string("PNG: png: ") + (png::has_libpng() ? "cloud read write" : ""),
                     "GeoTIFF: tif tiff: cloud write",
                     "EPT: ept.json: cloud read write",
                     "PTX: ptx: cloud read",
                     "PTS: pts: cloud read write",
                     "Text: xyz txt asc: cloud read write",
                     "CSV: csv: cloud read write",
                     "OBJ: obj: model read write",
                     "STL: stl: model read write",
                     "CityJSON: city.json cityjson json: model read write",
                     "DXF: dxf: model read write",
                     "GeoJSON: geojson: model write",
                     "glTF: glb: model write",
                     "IFC: ifc: model write",
                     std::string("GeoPackage: gpkg: ") + (has_sqlite() ? "model write" : ""),
                     "SVG: svg: drawing write"});
}

TEST_CASE("registry__rows_are_whole") {
  std::set<std::string> words;
  for (const Format& format : kFormats) {
    CAPTURE(format.name);
    CHECK((format.can_read() || format.can_write() || format.is_drawing));
    CHECK((format.content == Content::kSilent) == (format.recognises == nullptr));
    CHECK((format.content == Content::kCertain) == (*format.mark != '\0'));
    if (*format.keyword != '\0') CHECK(words.insert(format.keyword).second);
  }
}

TEST_CASE("registry__messages_list_what_the_rows_can") {
  CHECK(refusal("a.geojson", "{}", true) ==
        "GeoTIFF, GeoJSON, glTF, IFC and GeoPackage are written, not read");
  CHECK(refusal("a", "\x01\x02", false) ==
        "neither COPC, LAZ, E57, LAS, PLY, PCD, PNG, EPT, PTX, PTS, OBJ, STL, CityJSON, DXF nor "
        "text");
  CHECK(refusal("a.obj", "v 0 0 0\n", false) ==
        "OBJ, STL, CityJSON and DXF hold a model, no cloud");
  CHECK(refusal("a.xyz", "1 2 3\n", true) == "no model; models are CityJSON, DXF, OBJ, PLY or STL");
  if (!has_codecs())
    CHECK(has_text(refusal("a.xyz", "ASTM-E57 and more", false), "E57 needs the component"));
  CHECK(refusal_to_write("a.doc", false) ==
        "no format of extension \"doc\" can be written; there are: copc.laz, laz, e57, las, ply, "
        "pcd, png, tif, tiff, ept.json, pts, "
        "xyz, txt, asc, csv");
  CHECK(refusal_to_write("a.svg", true) ==
        "no format of extension \"svg\" can be written; there are: ply, obj, stl, city.json, "
        "cityjson, json, dxf, geojson, glb, ifc, gpkg");
}

TEST_CASE("registry__content_with_a_mark_outweighs_the_name_and_a_name_weaker_signs") {
  const Folder folder;
  Task task;
  WriteSettings settings;
  settings.format = "las";
  write_cloud(random_points(5, 2), folder.file("las_named.obj"), settings, task);
  CHECK(read_cloud(folder.file("las_named.obj"), {}, task).size() == 5);

  Model triangle;
  triangle.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  triangle.triangle_faces = {0};
  settings.format = "stl";
  write_model(triangle, folder.file("stl_named.txt"), settings, task);
  CHECK(read_model(folder.file("stl_named.txt"), {}, task).triangles.size() == 1);

  spill(folder.file("text_named.las"), "1 2 3\n");
  const Failure failure = failure_of([&] { read(folder.file("text_named.las")); });
  CHECK(failure.status == Status::kFormat);
  CHECK(failure.text.ends_with("a LAS file starts with LASF, this one does not"));
}
