// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "formats/city/boundaries.h"
#include "formats/city/city.h"
#include "formats/city/parts.h"
#include "formats/city/text.h"
#include "formats/city/tree.h"
#include "formats/files/utf8.h"
#include "formats/units/crs_code.h"
#include "model/part_classes.h"

namespace jalon {

namespace {

using namespace city;

class CityReader {
 public:
  CityReader(const ByteSource& source, Task& task)
      : source_(source), task_(task), boundaries_(model_, tree_) {}

  Model run() {
    read_whole();
    file_ = read_file_text(source_, task_, text_);
    read_transform();
    read_vertices();
    read_crs();
    read_objects();
    std::vector<uint32_t> new_index;
    if (!tree_.build(model_.parts, new_index))
      source_.refuse(file_.objects.offset(), "the parts are no tree of at most 64 levels");
    boundaries_.finish(new_index);
    if (boundaries_.dropped() != 0)
      task_.log(Task::kWarning, "%s: %zu surfaces without area left out", source_.path().c_str(),
                boundaries_.dropped());
    if (skipped_ != 0)
      task_.log(Task::kWarning, "%s: %zu geometries of points and lines left out",
                source_.path().c_str(), skipped_);
    return std::move(model_);
  }

 private:
  void read_whole() {
    constexpr size_t kBlock = size_t{4} << 20;
    text_.resize(source_.size());
    for (size_t at = 0; at < text_.size(); at += kBlock) {
      task_.checkpoint(0.2 * static_cast<double>(at) / static_cast<double>(text_.size()));
      source_.read(at, text_.data() + at, std::min(kBlock, text_.size() - at));
    }
  }

  static Vec3 read_triple(JsonCursor& cursor) {
    Vec3 out;
    cursor.begin_array();
    for (int k = 0; k < 3; ++k) {
      if (!cursor.next_element()) cursor.refuse("three numbers");
      out[k] = cursor.number();
    }
    if (cursor.next_element()) cursor.refuse("three numbers");
    return out;
  }

  void read_transform() {
    if (file_.transform.empty()) return;
    JsonCursor cursor = file_.transform.cursor();
    cursor.begin_object();
    for (std::string name; cursor.next_member(name);) {
      if (name == "scale") scale_ = read_triple(cursor);
      else if (name == "translate") translate_ = read_triple(cursor);
      else cursor.skip();
    }
  }

  void read_vertices() {
    size_t count = 0;
    JsonCursor counter = file_.vertices.cursor();
    for (counter.begin_array(); counter.next_element(); ++count) counter.skip();
    if (count > std::numeric_limits<uint32_t>::max())
      source_.refuse(file_.vertices.offset(), "more than 2^32 vertices");
    model_.vertices.reserve(count);
    JsonCursor cursor = file_.vertices.cursor();
    for (cursor.begin_array(); cursor.next_element();) {
      const Vec3 p = read_triple(cursor);
      model_.vertices.push_back({p.x * scale_.x + translate_.x, p.y * scale_.y + translate_.y,
                                 p.z * scale_.z + translate_.z});
      if (!is_finite(model_.vertices.back())) cursor.refuse("a finite vertex");
    }
  }

  void read_crs() {
    if (file_.metadata.empty()) return;
    JsonCursor cursor = file_.metadata.cursor();
    cursor.begin_object();
    for (std::string name; cursor.next_member(name);) {
      if (name != "referenceSystem" || cursor.kind() != JsonCursor::Kind::kText) {
        cursor.skip();
        continue;
      }
      const std::string system = cursor.text();
      const uint32_t code = metric_epsg_code(system);
      model_.crs = code != 0 ? "EPSG:" + std::to_string(code) : valid_utf8(system);
    }
  }

  /// One CityObject: its part, if it is one, and then its geometry.
  void read_objects() {
    JsonCursor cursor = file_.objects.cursor();
    std::map<std::string, uint32_t> drafts;
    std::vector<std::pair<uint32_t, std::string>> parents;
    cursor.begin_object();
    for (std::string id; cursor.next_member(id);) {
      task_.checkpoint(0.6);
      Draft draft;
      draft.part.name = name_from_file(id, "object");
      Piece geometry;
      std::string parent, type;
      read_attributes(cursor, draft, [&](const std::string& name) {
        if (name == "type") type = cursor.text();
        else if (name == "attributes") read_object_attributes(cursor, draft);
        else if (name == "geometry") geometry = file_.objects.value(cursor);
        else if (name == "parents") parent = first_text(cursor);
        else return false;
        return true;
      });
      if (draft.number == kNoNumber || draft.part.part_class.empty())
        draft.part.part_class = class_of_object(type);
      const uint32_t object = tree_.add(std::move(draft));
      drafts.emplace(id, object);
      if (!parent.empty()) parents.emplace_back(object, parent);
      if (!geometry.empty()) read_geometries(geometry, object);
    }
    for (const auto& [child, parent] : parents)
      if (const auto found = drafts.find(parent); found != drafts.end() && found->second != child)
        tree_.at(child).parent = found->second;
  }

  // Attributes of the building, and the parts without surfaces that our own files list there.
  void read_object_attributes(JsonCursor& cursor, Draft& draft) {
    if (cursor.kind() != JsonCursor::Kind::kObject) {
      cursor.skip();
      return;
    }
    read_attributes(cursor, draft, [&](const std::string& name) {
      if (name != "groups" || cursor.kind() != JsonCursor::Kind::kArray) return false;
      for (cursor.begin_array(); cursor.next_element();) {
        Draft group;
        if (cursor.kind() != JsonCursor::Kind::kObject) cursor.refuse("an object");
        read_attributes(cursor, group, [](const std::string&) { return false; });
        if (group.number != kNoNumber) tree_.add(std::move(group));
      }
      return true;
    });
  }

  static std::string first_text(JsonCursor& cursor) {
    std::string out;
    for (cursor.begin_array(); cursor.next_element();)
      if (out.empty() && cursor.kind() == JsonCursor::Kind::kText) out = cursor.text();
      else cursor.skip();
    return out;
  }

  // Of several levels of detail the highest counts.
  void read_geometries(const Piece& list, uint32_t object) {
    double best = -1;
    for (const bool choosing : {true, false}) {
      JsonCursor cursor = list.cursor();
      for (cursor.begin_array(); cursor.next_element();) {
        GeometryText geometry = read_geometry_text(list, cursor);
        if (choosing) best = std::max(best, geometry.lod);
        if (choosing || geometry.lod != best) continue;
        classify(geometry, source_, list);
        if (geometry.has_surfaces) add_geometry(geometry, object);
        else ++skipped_;
      }
    }
  }

  void add_geometry(const GeometryText& geometry, uint32_t object) {
    JsonCursor boundaries = geometry.boundaries.cursor();
    if (geometry.values.empty() || geometry.surfaces.empty())
      return boundaries_.read(boundaries, nullptr, geometry.depth, object, {});
    const std::vector<uint32_t> drafts = read_surfaces(geometry, object);
    JsonCursor values = geometry.values.cursor();
    boundaries_.read(boundaries, &values, geometry.depth, object, drafts);
  }

  // Marks the semantic surfaces that are used: values are numbers, nulls and lists of them.
  static void mark(JsonCursor& values, std::vector<bool>& used) {
    switch (values.kind()) {
      case JsonCursor::Kind::kArray:
        for (values.begin_array(); values.next_element();) mark(values, used);
        break;
      case JsonCursor::Kind::kNumber:
        if (const int64_t i = values.integer(); i >= 0 && static_cast<size_t>(i) < used.size())
          used[static_cast<size_t>(i)] = true;
        break;
      default:
        values.skip();
    }
  }

  // A draft for each semantic surface that has polygons; the object's own for others.
  std::vector<uint32_t> read_surfaces(const GeometryText& geometry, uint32_t object) {
    size_t count = 0;
    JsonCursor counter = geometry.surfaces.cursor();
    for (counter.begin_array(); counter.next_element(); ++count) counter.skip();
    std::vector<bool> used(count, false);
    JsonCursor values = geometry.values.cursor();
    mark(values, used);
    std::vector<uint32_t> drafts;
    std::vector<int64_t> parents;
    JsonCursor cursor = geometry.surfaces.cursor();
    for (cursor.begin_array(); cursor.next_element();) {
      int64_t parent = -1;
      if (!used[drafts.size()]) cursor.skip();
      drafts.push_back(used[drafts.size()] ? read_surface(cursor, object, parent) : object);
      parents.push_back(parent);
    }
    for (size_t i = 0; i < drafts.size(); ++i)
      if (parents[i] >= 0 && static_cast<size_t>(parents[i]) < drafts.size() &&
          drafts[i] != object && drafts[static_cast<size_t>(parents[i])] != drafts[i])
        tree_.at(drafts[i]).parent = drafts[static_cast<size_t>(parents[i])];
    return drafts;
  }

  uint32_t read_surface(JsonCursor& cursor, uint32_t object, int64_t& parent) {
    Draft draft;
    std::string type;
    draft.parent = object;
    read_attributes(cursor, draft, [&](const std::string& name) {
      if (name == "type") type = cursor.text();
      else if (name == "parent" && cursor.kind() == JsonCursor::Kind::kNumber)
        parent = cursor.integer();
      else return false;
      return true;
    });
    const char* part_class = class_of_surface(type);
    draft.is_opening = part_class::is_opening(part_class);
    if (draft.part.part_class.empty()) draft.part.part_class = part_class;
    if (draft.part.name.empty() && draft.number == kNoNumber)
      draft.part.name = name_from_file(type, "surface");
    return tree_.add(std::move(draft));
  }

  const ByteSource& source_;
  Task& task_;
  std::string text_;
  FileText file_;
  Vec3 scale_{1, 1, 1}, translate_;
  Model model_;
  Tree tree_;
  Boundaries boundaries_;
  size_t skipped_ = 0;
};

}  // namespace

Model read_city(const ByteSource& source, const ReadSettings&, Task& task) {
  ProgressSpan span(task, 0, 0.99, "reading CityJSON");
  return CityReader(source, task).run();
}

}  // namespace jalon
