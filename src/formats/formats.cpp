// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/formats.h"

#include <cmath>
#include <cstring>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/files/readers.h"
#include "formats/files/utf8.h"

namespace jalon {

namespace {

enum class Format { kUnknown, kLas, kPly, kText, kCsv, kObj, kStl, kDxf, kCity, kGeoJson };

constexpr size_t kLookBytes = 4096;  // of the start of a file, to tell text from binary data

constexpr FormatInfo kFormats[] = {
    {"LAS", "las", "cloud read write"},
    {"PLY", "ply", "cloud read write, model read write"},
    {"Text", "xyz txt pts asc", "cloud read write"},
    {"CSV", "csv", "cloud read write"},
    {"OBJ", "obj", "model read write"},
    {"STL", "stl", "model read write"},
    {"CityJSON", "city.json cityjson json", "model read write"},
    {"DXF", "dxf", "model write"},
    {"GeoJSON", "geojson", "model write"},
    {"SVG", "svg", "drawing write"},
};

constexpr ParamRow kReadRows[] = {
    choice_row("format", "auto", "auto|las|ply|text|obj|stl|cityjson", "",
               "Format of the file; auto looks at its content, then its extension"),
    string_row("columns", "", "text",
               "Columns of a text file, e.g. \"x y z intensity\" or \"x y z i r g b nx ny nz\"; - "
               "or _ skips one. Empty: from the header, or "
               "guessed"),
    bool_row("drop_invalid", false, "",
             "Drop points whose coordinates are not finite instead of refusing the file"),
    choice_row("polygons", "auto", "auto|faces|mesh", "obj",
               "What the polygons of a file become: auto: faces with openings where the file tells them, as our own "
               "do, else the triangles of a mesh; faces: a face each"),
    choice_row("unit", "auto", "auto|metre|foot|us_survey_foot", "las",
               "Length unit of the file; auto takes it from the CRS"),
};

constexpr ParamRow kWriteRows[] = {
    choice_row("format", "auto", "auto|las|ply|text|csv|obj|stl|cityjson|dxf|geojson", "",
               "Format of the file; auto takes it from the extension"),
    choice_row("las_version", "auto", "auto|1.2|1.4", "las",
               "auto: that of the file it came from, 1.2 where it holds all fields"),
    number_row("scale", 0, 0, 1000, "m", "las",
               "Step of the stored coordinates; 0: that of the file it came from, else 0.0001 m"),
    choice_row("ply_format", "binary", "binary|binary_big_endian|ascii", "ply",
               "binary is little-endian"),
    integer_row("decimals", -1, -1, 17, "", "text",
                "Decimals of the coordinates; -1: as many as give the same number back"),
    number_row("chord_error_m", 0.001, 1e-6, 10, "m", "obj,ply,stl,cityjson,geojson,dxf",
               "Largest distance of the chords that stand for an arc, where a format knows no arcs"),
    choice_row("dxf_version", "r2000", "r12|r2000", "dxf",
               "r2000: AC1015, with units and planar polylines; r12: AC1009, for old programs"),
    choice_row("dxf_view", "world", "world|elevation", "dxf",
               "world: faces where they are in space; elevation: the facades flattened into the drawing plane, 1:1 in "
               "metres, x along the facade, y the height"),
    choice_row("stl_format", "binary", "binary|ascii", "stl",
               "binary: float32, less whole metres that its header names where coordinates are large; ascii: exact "
               "coordinates, a solid for each part"),
    number_row("city_scale_m", 0.0001, 1e-9, 1, "m", "cityjson", "Step of the stored coordinates"),
};

Format format_named(const std::string& name) {
  if (name == "las") return Format::kLas;
  if (name == "ply") return Format::kPly;
  if (name == "text") return Format::kText;
  if (name == "csv") return Format::kCsv;
  if (name == "obj") return Format::kObj;
  if (name == "stl") return Format::kStl;
  if (name == "dxf") return Format::kDxf;
  if (name == "cityjson" || name == "json") return Format::kCity;
  if (name == "geojson") return Format::kGeoJson;
  return Format::kUnknown;
}

std::string extension_of(const std::string& path) {
  const size_t dot = path.rfind('.');
  const size_t slash = path.rfind('/');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  return lower(std::string_view(path).substr(dot + 1));
}

Format format_of_extension(const std::string& path) {
  const std::string extension = extension_of(path);
  for (const char* text : {"xyz", "txt", "pts", "asc"})
    if (extension == text) return Format::kText;
  return format_named(extension);
}

bool looks_like_text(std::string_view start) {
  for (const char c : start)
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f')
      return false;
  return !start.empty();
}

Format format_of_content(const ByteSource& source) {
  char start[kLookBytes];
  const std::string_view look(start, source.read_some(0, start, sizeof start));
  if (look.empty()) source.refuse(0, "the file is empty");
  if (look.starts_with("LASF")) return Format::kLas;
  if (look.starts_with("ply\n") || look.starts_with("ply\r")) return Format::kPly;
  if (look.starts_with("ASTM-E57"))
    fail(Status::kUnsupported, "%s: this build cannot read E57", source.path().c_str());
  const Format by_name = format_of_extension(source.path());
  if (by_name == Format::kLas) source.refuse(0, "a LAS file starts with LASF, this one does not");
  if (by_name == Format::kPly) source.refuse(0, "a PLY file starts with ply, this one does not");
  if (by_name == Format::kObj || by_name == Format::kCity) return by_name;
  if (by_name == Format::kStl || is_binary_stl(source)) return Format::kStl;
  if (by_name == Format::kDxf || by_name == Format::kGeoJson)
    fail(Status::kUnsupported, "%s: DXF and GeoJSON are written, not read", source.path().c_str());
  if (by_name == Format::kText || by_name == Format::kCsv || looks_like_text(look))
    return Format::kText;
  fail(Status::kUnsupported, "%s: neither LAS, PLY, OBJ, STL, CityJSON nor text", source.path().c_str());
}

Format format_to_read(const ByteSource& source, const ParamSet& options) {
  const Format chosen = format_named(options.text("format"));
  return chosen != Format::kUnknown ? chosen : format_of_content(source);
}

Format format_to_write(const std::string& path, const ParamSet& options) {
  const Format chosen = format_named(options.text("format"));
  return chosen != Format::kUnknown ? chosen : format_of_extension(path);
}

[[noreturn]] void refuse_extension(const std::string& path, const char* known) {
  fail(Status::kUnsupported, "%s: no format of extension \"%s\" can be written; there are: %s",
       path.c_str(), extension_of(path).c_str(), known);
}

}  // namespace

std::span<const ParamRow> read_rows() { return kReadRows; }
std::span<const ParamRow> write_rows() { return kWriteRows; }
std::span<const FormatInfo> formats() { return kFormats; }

Cloud finish_cloud(Cloud cloud, const ByteSource& source, const ParamSet& options, Task& task) {
  constexpr size_t kFiniteGrain = size_t{1} << 17;
  const std::span<const double> xyz = cloud.xyz();
  const auto finite = [&](size_t i) {
    return std::isfinite(xyz[3 * i]) && std::isfinite(xyz[3 * i + 1]) &&
           std::isfinite(xyz[3 * i + 2]);
  };
  Span span(task, 0.95, 1);
  const uint64_t bad =
      parallel_reduce<uint64_t>(task, cloud.size(), kFiniteGrain, 0, [&](size_t begin, size_t end) {
        uint64_t count = 0;
        for (size_t i = begin; i < end; ++i) count += finite(i) ? 0 : 1;
        return count;
      });
  if (bad == 0) return cloud;
  std::vector<uint64_t> kept;
  if (options.flag("drop_invalid")) kept.reserve(cloud.size() - bad);
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (finite(i)) {
      if (options.flag("drop_invalid")) kept.push_back(i);
    } else if (!options.flag("drop_invalid")) {
      fail(Status::kFormat,
           "%s: point %zu has a coordinate that is not finite (%llu of %zu have); drop_invalid "
           "leaves them out",
           source.path().c_str(), i, static_cast<unsigned long long>(bad), cloud.size());
    }
  }
  task.log(Task::kWarning, "%s: %llu points with coordinates that are not finite left out",
           source.path().c_str(), static_cast<unsigned long long>(bad));
  return select(cloud, kept, task);
}

Cloud read_cloud(const std::string& path, const ParamSet& options, Task& task) {
  const ByteSource source(path);
  switch (format_to_read(source, options)) {
    case Format::kLas:
      return read_las(source, options, task);
    case Format::kPly:
      return read_ply(source, options, task);
    case Format::kObj:
    case Format::kStl:
    case Format::kCity:
      fail(Status::kUnsupported, "%s: OBJ, STL and CityJSON hold a model, no cloud", path.c_str());
    default:
      return read_text(source, options, task);
  }
}

void write_cloud(const Cloud& cloud, const std::string& path, const ParamSet& options, Task& task) {
  switch (format_to_write(path, options)) {
    case Format::kLas:
      return write_las(cloud, path, options, task);
    case Format::kPly:
      return write_ply(cloud, path, options, task);
    case Format::kText:
      return write_text(cloud, path, false, options, task);
    case Format::kCsv:
      return write_text(cloud, path, true, options, task);
    default:
      refuse_extension(path, "las, ply, xyz, txt, csv");
  }
}

Model read_model(const std::string& path, const ParamSet& options, Task& task) {
  const ByteSource source(path);
  switch (format_to_read(source, options)) {
    case Format::kPly:
      return read_ply_model(source, options, task);
    case Format::kObj:
      return read_obj(source, options, task);
    case Format::kStl:
      return read_stl(source, task);
    case Format::kCity:
      return read_city(source, options, task);
    default:
      fail(Status::kUnsupported, "%s: no model; models are CityJSON, OBJ, PLY or STL", path.c_str());
  }
}

void write_model(const Model& model, const std::string& path, const ParamSet& options, Task& task) {
  switch (format_to_write(path, options)) {
    case Format::kPly:
      return write_ply_model(model, path, options, task);
    case Format::kObj:
      return write_obj(model, path, options, task);
    case Format::kStl:
      return write_stl(model, path, options, task);
    case Format::kDxf:
      return write_dxf(model, path, options, task);
    case Format::kCity:
      return write_city(model, path, options, task);
    case Format::kGeoJson:
      return write_geojson(model, path, options, task);
    default:
      refuse_extension(path, "obj, dxf, city.json, geojson, stl, ply");
  }
}

}  // namespace jalon
