// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/city/text.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon::city {

FileText read_file_text(const ByteSource& source, Task& task, std::string_view text) {
  const Piece whole(source, task, text);
  FileText out;
  JsonCursor cursor = whole.cursor();
  std::string type, version;
  cursor.begin_object();
  for (std::string name; cursor.next_member(name);) {
    if (name == "type") type = cursor.text();
    else if (name == "version") version = cursor.text();
    else if (name == "transform") out.transform = whole.value(cursor);
    else if (name == "metadata") out.metadata = whole.value(cursor);
    else if (name == "CityObjects") out.objects = whole.value(cursor);
    else if (name == "vertices") out.vertices = whole.value(cursor);
    else cursor.skip();
  }
  cursor.end();
  if (type == "CityJSONFeature")
    fail(Status::kUnsupported, "%s: CityJSON text sequences are not supported",
         source.path().c_str());
  if (type != "CityJSON") source.refuse(0, "the type is not CityJSON");
  if (version != "2.0" && version != "1.1" && version != "1.0")
    fail(Status::kUnsupported, "%s: CityJSON of another version than 1.0, 1.1 and 2.0",
         source.path().c_str());
  if (out.objects.empty() || out.vertices.empty())
    source.refuse(0, "CityObjects or vertices are missing");
  return out;
}

GeometryText read_geometry_text(const Piece& list, JsonCursor& cursor) {
  GeometryText out;
  cursor.begin_object();
  for (std::string name; cursor.next_member(name);) {
    if (name == "type") {
      out.type = cursor.text();
    } else if (name == "lod") {
      double lod = -1;
      if (cursor.kind() == JsonCursor::Kind::kNumber) lod = cursor.number();
      else if (!parse_number(cursor.text(), lod) || !std::isfinite(lod)) lod = -1;
      out.lod = std::max(lod, -1.0);
    } else if (name == "boundaries") {
      out.boundaries = list.value(cursor);
    } else if (name == "semantics" && cursor.kind() == JsonCursor::Kind::kObject) {
      cursor.begin_object();
      for (std::string member; cursor.next_member(member);) {
        if (member == "surfaces") out.surfaces = list.value(cursor);
        else if (member == "values") out.values = list.value(cursor);
        else cursor.skip();
      }
    } else {
      cursor.skip();
    }
  }
  return out;
}

void classify(GeometryText& geometry, const ByteSource& source, const Piece& list) {
  const std::string& type = geometry.type;
  if (type == "GeometryInstance")
    fail(Status::kUnsupported, "%s: geometry templates of CityJSON are not supported",
         source.path().c_str());
  geometry.has_surfaces = type != "MultiPoint" && type != "MultiLineString";
  if (!geometry.has_surfaces) return;
  const bool surfaces = type == "MultiSurface" || type == "CompositeSurface";
  if (!surfaces && type != "Solid" && type != "MultiSolid" && type != "CompositeSolid")
    source.refuse(list.offset(), "a geometry of an unknown type");
  if (geometry.boundaries.empty()) source.refuse(list.offset(), "a geometry without boundaries");
  geometry.depth = surfaces ? 0 : type == "Solid" ? 1 : 2;
}

}  // namespace jalon::city
