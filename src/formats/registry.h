// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/city/city.h"
#include "formats/dxf/dxf.h"
#include "formats/e57/e57.h"
#include "formats/ept/ept.h"
#include "formats/files/byte_source.h"
#include "formats/files/cloud_pieces.h"
#include "formats/geojson/geojson.h"
#include "formats/geopackage/geopackage.h"
#include "formats/glb/glb.h"
#include "formats/ifc/ifc.h"
#include "formats/las/las.h"
#include "formats/obj/obj.h"
#include "formats/pcd/pcd.h"
#include "formats/ply/ply.h"
#include "formats/png/png.h"
#include "formats/pts/pts.h"
#include "formats/ptx/ptx.h"
#include "formats/settings.h"
#include "formats/stl/stl.h"
#include "formats/text/text.h"
#include "formats/tiff/tiff.h"
#include "model/model.h"
#include "model/part_attributes.h"

namespace jalon {

/// What the content of a file says of its format.
enum class Content {
  kSilent,   ///< nothing: the extension alone tells
  kCertain,  ///< all: every file begins with a mark, and one named so without it is refused
  kSome,     ///< some files are known by it whatever their name; the others by their extension
  kText,     ///< that it is plain text, like that of other formats: asked when all else is silent
};

/// What a library may have been built without, a bit each.
enum Component : unsigned {
  kNoComponent = 0,
  kCodecs = 1,  ///< the decoders of formats/codecs
  kSqlite = 2,
  kLibpng = 4,
};

/// A function that a format has, or none. That it is there is a flag: under its sanitizer of
/// undefined behaviour GCC takes no comparison with a function's address for a constant (bug 71962).
template <class F>
class Ability {
 public:
  constexpr Ability() = default;
  constexpr Ability(F* function) : function_(function), is_there_(true) {}

  constexpr bool operator==(std::nullptr_t) const { return !is_there_; }
  template <class... A>
  auto operator()(A&&... arguments) const {
    return function_(std::forward<A>(arguments)...);
  }

 private:
  F* function_ = nullptr;
  bool is_there_ = false;
};

/// A format of files: what it is called, how a file of it is known, and what can be done with it.
/// A function that it does not have is nullptr; all that users read about formats (the choices of
/// the options "format", the abilities, the lists in messages) follows from the rows.
struct Format {
  const char* name;
  const char* keyword;  ///< in the options "format", and an extension too; "" = a user cannot ask
  const char* extensions;  ///< separated by blanks: what may stand behind a dot of a file's name
  Content content = Content::kSilent;
  bool (*recognises)(const ByteSource& source) = nullptr;  ///< not for kSilent
  const char* mark = "";                                   ///< of kCertain, for messages
  Ability<Cloud(const ByteSource&, const ReadSettings&, Task&)> read_cloud{};
  Ability<void(const Cloud&, const std::string& path, const WriteSettings&, Task&)> write_cloud{};
  Ability<Model(const ByteSource&, const ReadSettings&, Task&)> read_model{};
  Ability<void(const Model&, const std::string& path, const WriteSettings&, Task&)> write_model{};
  /// The same with attributes of the parts; null where a format has no place for them.
  Ability<void(const Model&, const PartAttributes&, const std::string& path, const WriteSettings&,
               Task&)>
      write_attributes{};
  /// Null where this file's points do not come in the order of a cloud's.
  Ability<std::unique_ptr<CloudPieces>(const ByteSource&, const ReadSettings&, Task&)>
      read_pieces{};
  Ability<std::unique_ptr<CloudSink>(const std::string& path, const WriteSettings&,
                                     uint64_t points)>
      write_pieces{};
  bool keeps_stations = false;  ///< its files have a place for all stations of a cloud
  bool keeps_station = false;   ///< that of a cloud with one
  bool knows_units = false;     ///< its reader heeds the option "unit" and what the file says of it
  bool has_levels = false;      ///< all its files have their points in levels of a spacing
  bool reads_as_another = false;       ///< by the reader of a row before, which users name instead
  bool is_drawing = false;             ///< written by the room report
  Component component = kNoComponent;  ///< that it needs

  constexpr bool can_read() const { return read_cloud != nullptr || read_model != nullptr; }
  constexpr bool can_write() const { return write_cloud != nullptr || write_model != nullptr; }
};

inline constexpr Format kFormats[] = {
    {.name = "COPC",
     .keyword = "copc",
     .extensions = "copc.laz",
     .content = Content::kCertain,
     .recognises = is_copc,
     .mark = "LASF",
     .read_cloud = read_las,
     .write_cloud = write_copc,
     .read_pieces = las_pieces,
     .keeps_stations = true,
     .knows_units = true,
     .component = kCodecs},
    {.name = "LAZ",
     .keyword = "laz",
     .extensions = "laz",
     .content = Content::kCertain,
     .recognises = is_laz,
     .mark = "LASF",
     .read_cloud = read_las,
     .write_cloud = write_laz,
     .read_pieces = las_pieces,
     .write_pieces = laz_sink,
     .keeps_stations = true,
     .knows_units = true,
     .component = kCodecs},
    {.name = "E57",
     .keyword = "e57",
     .extensions = "e57",
     .content = Content::kCertain,
     .recognises = is_e57,
     .mark = "ASTM-E57",
     .read_cloud = read_e57,
     .write_cloud = write_e57,
     .keeps_stations = true,
     .component = kCodecs},
    {.name = "LAS",
     .keyword = "las",
     .extensions = "las",
     .content = Content::kCertain,
     .recognises = is_las,
     .mark = "LASF",
     .read_cloud = read_las,
     .write_cloud = write_las,
     .read_pieces = las_pieces,
     .write_pieces = las_sink,
     .keeps_stations = true,
     .knows_units = true},
    {.name = "PLY",
     .keyword = "ply",
     .extensions = "ply",
     .content = Content::kCertain,
     .recognises = is_ply,
     .mark = "ply",
     .read_cloud = read_ply,
     .write_cloud = write_ply,
     .read_model = read_ply_model,
     .write_model = write_ply_model,
     .keeps_stations = true},
    {.name = "PCD",
     .keyword = "pcd",
     .extensions = "pcd",
     .content = Content::kSome,
     .recognises = is_pcd,
     .read_cloud = read_pcd,
     .write_cloud = write_pcd,
     .keeps_station = true},
    {.name = "PNG",
     .keyword = "png",
     .extensions = "png",
     .content = Content::kCertain,
     .recognises = is_png,
     .mark = "0x89 and PNG",
     .read_cloud = read_png,
     .write_cloud = write_png,
     .component = kLibpng},
    {.name = "GeoTIFF",
     .keyword = "tif",
     .extensions = "tif tiff",
     .write_cloud = write_depth_tiff},
    {.name = "EPT",
     .keyword = "ept",
     .extensions = "ept.json",
     .read_cloud = read_ept,
     .write_cloud = write_ept,
     .keeps_stations = true,
     .has_levels = true},
    {.name = "PTX", .keyword = "ptx", .extensions = "ptx", .read_cloud = read_ptx},
    {.name = "PTS",
     .keyword = "pts",
     .extensions = "pts",
     .read_cloud = read_pts,
     .write_cloud = write_text,
     .write_pieces = text_sink},
    {.name = "Text",
     .keyword = "text",
     .extensions = "xyz txt asc",
     .content = Content::kText,
     .recognises = is_plain_text,
     .read_cloud = read_text,
     .write_cloud = write_text,
     .read_pieces = text_pieces,
     .write_pieces = text_sink},
    {.name = "CSV",
     .keyword = "csv",
     .extensions = "csv",
     .content = Content::kText,
     .recognises = is_plain_text,
     .read_cloud = read_text,
     .write_cloud = write_csv,
     .read_pieces = text_pieces,
     .write_pieces = csv_sink,
     .reads_as_another = true},
    {.name = "OBJ",
     .keyword = "obj",
     .extensions = "obj",
     .read_model = read_obj,
     .write_model = write_obj},
    {.name = "STL",
     .keyword = "stl",
     .extensions = "stl",
     .content = Content::kSome,
     .recognises = is_binary_stl,
     .read_model = read_stl,
     .write_model = write_stl},
    {.name = "CityJSON",
     .keyword = "cityjson",
     .extensions = "city.json cityjson json",
     .read_model = read_city,
     .write_model = write_city,
     .write_attributes = write_city_attributes},
    {.name = "DXF",
     .keyword = "dxf",
     .extensions = "dxf",
     .read_model = read_dxf,
     .write_model = write_dxf},
    {.name = "GeoJSON",
     .keyword = "geojson",
     .extensions = "geojson",
     .write_model = write_geojson},
    {.name = "glTF", .keyword = "glb", .extensions = "glb", .write_model = write_glb},
    {.name = "IFC", .keyword = "ifc", .extensions = "ifc", .write_model = write_ifc},
    {.name = "GeoPackage",
     .keyword = "gpkg",
     .extensions = "gpkg",
     .write_model = write_geopackage,
     .component = kSqlite},
    {.name = "SVG", .keyword = "", .extensions = "svg", .is_drawing = true},
};

}  // namespace jalon
