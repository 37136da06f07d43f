// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <iterator>
#include <string_view>

#include "base/setting_rows.h"
#include "formats/codecs/codecs.h"
#include "formats/formats.h"
#include "formats/geopackage/sqlite_database.h"
#include "formats/png/grey_file.h"
#include "formats/registry.h"
#include "formats/wanted_points.h"

// What users read about formats, made from the registry when the library is compiled.
namespace jalon {

namespace {

constexpr size_t kCount = std::size(kFormats);

/// A text put together at compile time; one that does not fit does not compile.
struct FixedText {
  std::array<char, 128> bytes{};
  size_t used = 0;
  constexpr void add(std::string_view text) {
    for (const char c : text) bytes[used++] = c;
    bytes[used] = '\0';
  }
};

constexpr FixedText choices(bool reading) {
  FixedText text;
  text.add("auto");
  for (size_t i = 0; i < kCount; ++i) {
    const Format& format = kFormats[i];
    if (std::string_view(format.keyword).empty()) continue;
    if (reading ? !format.can_read() || format.reads_as_another : !format.can_write()) continue;
    text.add("|");
    text.add(format.keyword);
  }
  return text;
}

constexpr void add_ability(FixedText& text, std::string_view what, bool reads, bool writes) {
  if (!reads && !writes) return;
  if (text.used != 0) text.add(", ");
  text.add(what);
  if (reads) text.add(" read");
  if (writes) text.add(" write");
}

constexpr FixedText abilities_of(const Format& format, unsigned components) {
  FixedText text;
  if ((format.component & ~components) != 0) return text;
  add_ability(text, "cloud", format.read_cloud != nullptr, format.write_cloud != nullptr);
  add_ability(text, "model", format.read_model != nullptr, format.write_model != nullptr);
  add_ability(text, "drawing", false, format.is_drawing);
  return text;
}

/// The table as users see it, of a library with these optional components.
template <unsigned components>
constexpr auto kAbilities = [] {
  std::array<FixedText, kCount> all{};
  for (size_t i = 0; i < kCount; ++i) all[i] = abilities_of(kFormats[i], components);
  return all;
}();

template <unsigned components>
constexpr auto kInfos = [] {
  std::array<FormatInfo, kCount> all{};
  for (size_t i = 0; i < kCount; ++i)
    all[i] = {kFormats[i].name, kFormats[i].extensions, kAbilities<components>[i].bytes.data()};
  return all;
}();

constexpr FixedText kReadChoices = choices(true), kWriteChoices = choices(false);

// What clouds have of "read" and "write" is said here once, for "convert" too.
constexpr auto kTextRows = setting_rows(
    string_row<&ReadSettings::columns>(
        "columns", "text",
        "Columns of a text file, e.g. \"x y z intensity\" or \"x y z i r g b nx ny nz\"; - "
        "or _ skips one. Empty: from the header, or "
        "guessed"),
    bool_row<&ReadSettings::drop_invalid>(
        "drop_invalid", "",
        "Drop points whose coordinates are not finite instead of refusing the file"));
constexpr auto kPlaceRows = setting_rows(
    choice_row<&ReadSettings::unit>(
        "unit", "auto|metre|foot|us_survey_foot|millimetre|centimetre", "las,ply,text,dxf",
        "Length unit of the coordinates of a cloud's file or of a drawing, which become metres; "
        "auto: that of the CRS of a LAS file, of a drawing's header, else metres"),
    doubles_row<&ReadSettings::box>(
        "box", -1e15, 1e15, "m", "",
        "Read a cloud's points in this closed box alone: least x, y, z, then greatest. Of a COPC "
        "file and of EPT only the nodes that it touches are read. Empty: all points"),
    number_row<&ReadSettings::spacing_m>("spacing_m", 0, 1e9, "m", "copc,ept",
                                         "Read the octree of a COPC file or of EPT down to the "
                                         "level whose points stand no wider apart than this; "
                                         "0: all points"),
    string_row<&ReadSettings::station>("station", "",
                                       "Read the points of this scan station alone: its name, or "
                                       "its number from 1. Empty: of all"),
    integer_row<&ReadSettings::max_points>("max_points", 0, kMostKeptPoints, "points", "",
                                           "Most points of a cloud: of those that the other "
                                           "options leave, so many are kept evenly, in "
                                           "the order of the file; 0: all"),
    string_row<&ReadSettings::fields>(
        "fields", "",
        "Fields of a cloud to read, by name, separated by blanks or commas, as \"intensity "
        "classification\"; one that the file lacks is an error, unless a question mark follows its "
        "name. \"-\": none; empty: all"),
    number_row<&ReadSettings::png_source_pixel_m>(
        "png_source_pixel_m", 0, 1000, "m", "png",
        "Edge of a pixel of a PNG file that tells none, neither itself nor by a world file (pgw)"),
    number_row<&ReadSettings::png_step_m>(
        "png_step_m", -1000, 1000, "m", "png",
        "Depth of one grey value of a PNG file that does not tell it; negative where greater "
        "values are farther away"),
    number_row<&ReadSettings::png_zero_m>("png_zero_m", -1e9, 1e9, "m", "png",
                                          "Depth of grey value 0 of such a file"));

constexpr auto kReadRows = setting_rows(
    choice_row<&ReadSettings::format>(
        "format", kReadChoices.bytes.data(), "",
        "Format of the file; auto looks at its content, then its extension"),
    kTextRows,
    choice_row<&ReadSettings::polygons>(
        "polygons", "auto|faces|mesh", "obj,dxf",
        "What the polygons of a file become: auto: faces with openings where the file tells them, "
        "as our own do, else the triangles of a mesh; faces: a face each"),
    kPlaceRows);

constexpr auto kWriteCloudRows = setting_rows(
    choice_row<&WriteSettings::format>("format", kWriteChoices.bytes.data(), "",
                                       "Format of the file; auto takes it from the extension"),
    choice_row<&WriteSettings::las_version>(
        "las_version", "auto|1.2|1.4", "las,laz",
        "auto: that of the file it came from, 1.2 where it holds all fields, 1.3 for wave packets"),
    number_row<&WriteSettings::scale>(
        "scale", 0, 1000, "m", "las,laz,copc,ept,e57",
        "Step of the stored coordinates; 0: that of the file it came from, else 0.0001 m; of E57: "
        "whole doubles"),
    choice_row<&WriteSettings::ply_format>("ply_format", "binary|binary_big_endian|ascii", "ply",
                                           "binary is little-endian"),
    doubles_row<&WriteSettings::png_direction>(
        "png_direction", -1, 1, "1", "png,tif",
        "Where a depth image is seen from: x, y, z toward the viewer; empty: from above"),
    number_row<&WriteSettings::png_pixel_m>(
        "png_pixel_m", 0, 1000, "m", "png,tif",
        "Edge of a pixel of a depth image; 0: two points a pixel on average"),
    choice_row<&WriteSettings::png_bits>("png_bits", "16|8", "png",
                                         "Bits of a grey value of a depth image"),
    integer_row<&WriteSettings::decimals>(
        "decimals", -1, 17, "", "text",
        "Decimals of the coordinates; -1: as many as give the same number back"));

constexpr auto kWriteRows = setting_rows(
    kWriteCloudRows,
    number_row<&WriteSettings::chord_error_m>(
        "chord_error_m", 1e-6, 10, "m", "obj,ply,stl,cityjson,geojson,dxf,glb,ifc,gpkg",
        "Largest distance of the chords that stand for an arc, where a format knows no arcs"),
    choice_row<&WriteSettings::dxf_version>(
        "dxf_version", "r12|r2000", "dxf",
        "r2000: AC1015, with units and planar polylines; r12: AC1009, for old programs"),
    choice_row<&WriteSettings::dxf_view>(
        "dxf_view", "world|elevation", "dxf",
        "world: faces where they are in space; elevation: the facades flattened into the drawing "
        "plane, 1:1 in metres, x along the facade, y the height"),
    string_row<&WriteSettings::dxf_images>(
        "dxf_images", "dxf",
        "Orthoimages of facades that the drawing links: PNG files with a world file (pgw) beside "
        "each, separated by |; those in the drawing's folder by their name alone"),
    choice_row<&WriteSettings::stl_format>(
        "stl_format", "binary|ascii", "stl",
        "binary: float32, less whole metres that its header names where coordinates are large; "
        "ascii: exact coordinates, a solid for each part"),
    number_row<&WriteSettings::city_scale_m>("city_scale_m", 1e-9, 1, "m", "cityjson",
                                             "Step of the stored coordinates"),
    number_row<&WriteSettings::ifc_wall_thickness_m>(
        "ifc_wall_thickness_m", 0, 10, "m", "ifc",
        "Walls as solids of this thickness behind their measured surfaces, cut by their openings; "
        "0: the surfaces alone, "
        "with holes, since a scan of the outside tells no thickness"),
    number_row<&WriteSettings::gpkg_plan_height_m>(
        "gpkg_plan_height_m", 0, 1000, "m", "gpkg",
        "Height above the foot of each facade at which the lines of the plan cut it"));

constexpr auto kReadCloudRows =
    setting_rows(choice_row<&ReadSettings::format>(
                     "read_format", kReadChoices.bytes.data(), "",
                     "Format of the file read; auto looks at its content, then its extension"),
                 kTextRows, kPlaceRows);
constexpr auto kConvertRows =
    setting_rows(nested_rows<&ConvertSettings::reading, kReadCloudRows>(),
                 nested_rows<&ConvertSettings::writing, kWriteCloudRows>());

}  // namespace

std::span<const ParamRow> read_rows() { return kReadRows; }
std::span<const ParamRow> write_rows() { return kWriteRows; }
std::span<const ParamRow> convert_rows() { return kConvertRows; }
std::span<const FormatInfo> formats() {
  using Table = std::span<const FormatInfo>;
  static constexpr std::array<Table, 8> kTables{kInfos<0>, kInfos<1>, kInfos<2>, kInfos<3>,
                                                kInfos<4>, kInfos<5>, kInfos<6>, kInfos<7>};
  return kTables[(has_codecs() ? kCodecs : 0u) | (has_sqlite() ? kSqlite : 0u) |
                 (png::has_libpng() ? kLibpng : 0u)];
}

}  // namespace jalon
