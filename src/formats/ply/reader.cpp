// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/files/component.h"
#include "formats/files/finish_cloud.h"
#include "formats/files/told_stations.h"
#include "formats/files/utf8.h"
#include "formats/ply/cursor.h"
#include "formats/ply/ply.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

using namespace ply;

constexpr size_t kReaderGrain = size_t{1} << 15;  // vertices a chunk
constexpr size_t kBlockBytes = size_t{96} << 10;  // read at once
constexpr size_t kTicks = 4096;                   // items between two looks at the task

const Element& require_vertices(const ByteSource& source, const Header& header) {
  for (const Element& element : header.elements)
    if (element.name == "vertex") return element;
  source.refuse(header.data_offset, "the file has no vertices");
}

/// Where a property of the vertices goes; nothing for lists.
struct Sink {
  void* out = nullptr;
  size_t stride = 1;  ///< elements from one vertex to the next
  ElementType type = ElementType::kFloat64;
};

struct Vertices {
  Buffer<double> xyz;
  std::vector<std::shared_ptr<Column>> columns;
  std::vector<Sink> sinks;  ///< one a property
};

bool is_property(const Element& element, const std::string& name) {
  return std::ranges::count_if(element.properties,
                               [&](const Property& p) { return !p.list && p.name == name; }) == 1;
}

std::string field_name(const Property& property, const Header& header, UniqueNames& unique) {
  std::string name = property.name;
  if (header.by_cloudcompare && name.starts_with("scalar_") && name.size() > 7) name.erase(0, 7);
  return unique.add(name);
}

Vertices prepare(const ByteSource& source, const Header& header, const Element& element,
                 bool with_fields) {
  for (const char* name : {"x", "y", "z"})
    if (!is_property(element, name))
      source.refuse(header.data_offset, "the vertices need one property %s", name);
  const size_t count = element.count;
  Vertices out;
  out.xyz = Buffer<double>(3 * count);
  const bool normals = with_fields && is_property(element, "nx") && is_property(element, "ny") &&
                       is_property(element, "nz");
  std::shared_ptr<Column> normal;
  if (normals) {
    normal = std::make_shared<Column>(
        FieldInfo{"normal", ElementType::kFloat32, 3, "", "unit normal"}, count);
    out.columns.push_back(normal);
  }
  UniqueNames unique;
  unique.add("normal");
  for (const Property& property : element.properties) {
    Sink sink;
    bool is_placed = property.list;
    for (size_t k = 0; k < 3 && !property.list; ++k) {
      if (property.name == std::string_view("xyz").substr(k, 1)) {
        sink = {component(out.xyz.data(), k), 3, ElementType::kFloat64};
        is_placed = true;
      } else if (normals && property.name == std::string("n") + "xyz"[k]) {
        sink = {component(static_cast<float*>(normal->raw()), k), 3, ElementType::kFloat32};
        is_placed = true;
      }
    }
    if (!is_placed && with_fields) {
      out.columns.push_back(std::make_shared<Column>(
          FieldInfo{field_name(property, header, unique), property.type, 1, "", ""}, count));
      sink = {out.columns.back()->raw(), 1, property.type};
    }
    out.sinks.push_back(sink);
  }
  return out;
}

// One property of a block of binary vertices into its sink.
template <std::endian Order>
void copy_block(const char* from, size_t record, size_t n, ElementType stored, const Sink& sink,
                size_t first) {
  visit(stored, [&](auto stored_zero) {
    using Stored = decltype(stored_zero);
    const auto copy = [&](auto zero) {
      using T = decltype(zero);
      T* out = static_cast<T*>(sink.out) + first * sink.stride;
      for (size_t i = 0; i < n; ++i)
        out[i * sink.stride] = static_cast<T>(load<Stored, Order>(from + i * record));
    };
    if (sink.type == stored) return copy(Stored{});
    return sink.type == ElementType::kFloat32 ? copy(float{}) : copy(double{});
  });
}

void read_binary_vertices(const ByteSource& source, const Header& header, const Element& element,
                          uint64_t offset, const Vertices& vertices, Task& task) {
  const auto record = static_cast<size_t>(element.least_bytes(header.encoding));
  const size_t block = std::max<size_t>(1, kBlockBytes / record);
  parallel_for(task, element.count, kReaderGrain, [&](size_t begin, size_t end) {
    const auto bytes =
        std::make_unique_for_overwrite<char[]>(std::min(block, end - begin) * record);
    for (size_t first = begin; first < end; first += block) {
      const size_t n = std::min(block, end - first);
      source.read(offset + uint64_t{first} * record, bytes.get(), n * record);
      size_t at = 0;
      for (size_t p = 0; p < element.properties.size(); ++p) {
        const ElementType stored = element.properties[p].type;
        if (vertices.sinks[p].out != nullptr) {
          if (header.encoding == Encoding::kLittle)
            copy_block<std::endian::little>(bytes.get() + at, record, n, stored, vertices.sinks[p],
                                            first);
          else
            copy_block<std::endian::big>(bytes.get() + at, record, n, stored, vertices.sinks[p],
                                         first);
        }
        at += size_of(stored);
      }
    }
  });
}

void read_vertices_one_by_one(Cursor& cursor, const Element& element, const Vertices& vertices,
                              Task& task) {
  for (size_t i = 0; i < element.count; ++i) {
    if (i % kTicks == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(element.count));
    for (size_t p = 0; p < element.properties.size(); ++p) {
      const Property& property = element.properties[p];
      const Sink& sink = vertices.sinks[p];
      if (sink.out == nullptr) cursor.skip(property);
      else
        visit(sink.type, [&](auto zero) {
          using T = decltype(zero);
          static_cast<T*>(sink.out)[i * sink.stride] = cursor.value<T>(property.type);
        });
    }
  }
}

void skip_element(Cursor& cursor, const Header& header, const Element& element, Task& task) {
  if (element.properties.empty()) return;
  if (header.encoding != Encoding::kAscii && !element.has_list())
    return cursor.skip_bytes(element.count * element.least_bytes(header.encoding));
  for (uint64_t i = 0; i < element.count; ++i) {
    if (i % kTicks == 0) task.checkpoint(0);
    for (const Property& property : element.properties) cursor.skip(property);
  }
}

// Leaves the cursor behind the vertices.
Vertices read_vertices(const ByteSource& source, const Header& header, Cursor& cursor,
                       bool with_fields, Task& task) {
  const Element& element = require_vertices(source, header);
  for (const Element& before : header.elements) {
    if (&before == &element) break;
    skip_element(cursor, header, before, task);
  }
  if (header.encoding != Encoding::kAscii && !element.has_list() &&
      element.count * element.least_bytes(header.encoding) > cursor.remaining())
    source.refuse(cursor.offset(), "the file ends before the last of %llu vertices",
                  static_cast<unsigned long long>(element.count));
  Vertices vertices = prepare(source, header, element, with_fields);
  if (header.encoding == Encoding::kAscii || element.has_list()) {
    read_vertices_one_by_one(cursor, element, vertices, task);
  } else {
    read_binary_vertices(source, header, element, cursor.offset(), vertices, task);
    cursor.skip_bytes(element.count * element.least_bytes(header.encoding));
  }
  return vertices;
}

// Index of the list of corners among the properties of the faces.
size_t corner_list(const ByteSource& source, const Header& header, const Element& faces) {
  for (size_t p = 0; p < faces.properties.size(); ++p)
    if (faces.properties[p].list && (faces.properties[p].name == "vertex_indices" ||
                                     faces.properties[p].name == "vertex_index"))
      return p;
  source.refuse(header.data_offset, "the faces have no list vertex_indices");
}

void read_faces(const ByteSource& source, const Header& header, const Element& faces,
                Cursor& cursor, Model& model, Task& task) {
  const size_t list = corner_list(source, header, faces);
  std::vector<uint32_t> polygon;
  for (uint64_t f = 0; f < faces.count; ++f) {
    if (f % kTicks == 0) task.checkpoint(static_cast<double>(f) / static_cast<double>(faces.count));
    for (size_t p = 0; p < faces.properties.size(); ++p) {
      const Property& property = faces.properties[p];
      if (p != list) {
        cursor.skip(property);
        continue;
      }
      const uint64_t length = cursor.list_length(property);
      polygon.clear();
      for (uint64_t c = 0; c < length; ++c) {
        const uint64_t at = cursor.offset();
        const auto index = cursor.value<int64_t>(property.type);
        if (index < 0 || static_cast<uint64_t>(index) >= model.vertices.size())
          source.refuse(at, "face %llu names vertex %lld of %zu",
                        static_cast<unsigned long long>(f), static_cast<long long>(index),
                        model.vertices.size());
        polygon.push_back(static_cast<uint32_t>(index));
        if (c % kTicks == 0) task.checkpoint(0);
      }
      append_polygon(model, polygon, static_cast<uint32_t>(f));
    }
  }
}

Cloud with_stations(Cloud cloud, const Header& header, const std::string& path, Task& task) {
  ToldStations told;
  try {
    for (const std::string& text : header.stations) read_stations(text, told);
  } catch (const Error& error) {
    if (error.status() != Status::kFormat) throw;
    task.log(Task::kWarning, "%s: the stations are left out: %s", path.c_str(), error.what());
    return cloud;
  }
  return with_told_stations(std::move(cloud), told, {1, 1, 1}, path, task);
}

}  // namespace

bool is_ply(const ByteSource& source) {
  char start[4];
  const std::string_view look(start, source.read_some(0, start, sizeof start));
  return look == "ply\n" || look == "ply\r";
}

Cloud read_ply(const ByteSource& source, const ReadSettings& settings, Task& task) {
  const Header header = read_header(source);
  Cursor cursor(source, header.encoding, header.data_offset);
  Vertices vertices;
  {
    ProgressSpan span(task, 0, 0.95, "reading PLY");
    vertices = read_vertices(source, header, cursor, true, task);
  }
  Cloud cloud = make_cloud(std::move(vertices.xyz));
  for (auto& column : vertices.columns) cloud.fields.set(std::move(column));
  cloud.crs = header.crs;
  cloud = with_stations(std::move(cloud), header, source.path(), task);
  return finish_cloud(std::move(cloud), source, settings.drop_invalid, task);
}

Model read_ply_model(const ByteSource& source, const ReadSettings&, Task& task) {
  const Header header = read_header(source);
  const auto faces =
      std::ranges::find_if(header.elements, [](const Element& e) { return e.name == "face"; });
  if (faces == header.elements.end())
    source.refuse(header.data_offset, "the file has no faces; it is a cloud");
  const Element& element = require_vertices(source, header);
  if (&element > &*faces)
    source.refuse(header.data_offset, "faces before their vertices are not supported");
  Cursor cursor(source, header.encoding, header.data_offset);
  Model model;
  {
    ProgressSpan span(task, 0, 0.4, "reading PLY");
    const Vertices vertices = read_vertices(source, header, cursor, false, task);
    model.vertices.resize(element.count);
    for (size_t i = 0; i < element.count; ++i)
      model.vertices[i] = {vertices.xyz[3 * i], vertices.xyz[3 * i + 1], vertices.xyz[3 * i + 2]};
  }
  for (const Element* between = &element + 1; between != &*faces; ++between)
    skip_element(cursor, header, *between, task);
  ProgressSpan span(task, 0.4, 0.99, "reading PLY");
  for (size_t i = 0; i < model.vertices.size(); ++i)
    if (!is_finite(model.vertices[i]))
      source.refuse(header.data_offset, "vertex %zu is not finite", i);
  read_faces(source, header, *faces, cursor, model, task);
  return model;
}

}  // namespace jalon
