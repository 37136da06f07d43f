// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/face_geometry.h"
#include "formats/files/fast_number.h"
#include "formats/files/utf8.h"
#include "formats/obj/notes.h"
#include "formats/obj/obj.h"
#include "formats/text/line_reader.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

constexpr size_t kTicks = 4096;  // lines between two looks at the task

class ObjReader {
 public:
  ObjReader(const ByteSource& source, Polygons polygons, Task& task)
      : source_(source),
        task_(task),
        lines_(source),
        as_faces_(polygons == Polygons::kFaces),
        with_notes_(polygons == Polygons::kAuto) {}

  Model run() {
    std::string_view line;
    std::string joined;
    while (lines_.next(line)) {
      if (lines_.number() == 1) with_notes_ = with_notes_ && line.starts_with("# Jalon");
      if (lines_.number() % kTicks == 0) task_.checkpoint(lines_.fraction());
      // A backslash at the end carries the statement on to the next line.
      if (!line.empty() && line.back() == '\\') {
        joined.append(line.substr(0, line.size() - 1)).append(" ");
        if (joined.size() > kMaxLineBytes) refuse("a statement is too long");
        continue;
      }
      if (joined.empty()) {
        statement(line);
      } else {
        joined.append(line);
        statement(joined);
        joined.clear();
      }
    }
    if (!joined.empty()) statement(joined);
    if (model_.vertices.empty()) refuse("there are no vertices");
    if (notes_.has_faces()) build_faces();
    // Without groups every polygon is a face of its own.
    else if (!groups_.empty()) model_.triangle_faces.swap(group_of_triangle_);
    return std::move(model_);
  }

 private:
  [[noreturn]] void refuse(const char* reason) const {
    fail(Status::kFormat, "%.400s: line %llu: %s", source_.path().c_str(),
         static_cast<unsigned long long>(lines_.number()), reason);
  }

  // The faces that the notes tell, instead of the triangles and polygons that draw them.
  void build_faces() {
    const auto own = static_cast<std::ptrdiff_t>(
        std::min(notes_.own_triangles(model_.triangles.size()), model_.triangles.size()));
    model_.triangles.erase(model_.triangles.begin(), model_.triangles.begin() + own);
    group_of_triangle_.erase(group_of_triangle_.begin(), group_of_triangle_.begin() + own);
    std::vector<uint32_t> number_of_group;  // "face_7" is 7
    for (size_t g = 0; g < model_.parts.size(); ++g) {
      int64_t number = 0;
      const std::string& name = model_.parts[g].name;
      const bool known = name.starts_with("face_") && parse_integer(name.substr(5), number) &&
                         number >= 0 && number <= std::numeric_limits<uint32_t>::max();
      number_of_group.push_back(known ? static_cast<uint32_t>(number) : static_cast<uint32_t>(g));
    }
    model_.triangle_faces.clear();
    for (const uint32_t g : group_of_triangle_)
      model_.triangle_faces.push_back(g < number_of_group.size() ? number_of_group[g] : g);
    if (!notes_.build(model_))
      refuse("the notes \"#:\" on parts, faces and solids do not fit together");
  }

  static bool is_blank(char c) { return c == ' ' || c == '\t'; }

  static std::string_view next_word(std::string_view& line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    size_t n = 0;
    while (n < line.size() && !is_blank(line[n])) ++n;
    const std::string_view word = line.substr(0, n);
    line.remove_prefix(n);
    return word;
  }

  void statement(std::string_view line) {
    const std::string_view keyword = next_word(line);
    if (keyword == "v") return vertex(line);
    if (keyword == "f") return face(line);
    if (keyword == "l" && notes_.wants_ring()) return polyline(line);
    if (keyword == "g" || keyword == "o") return group(line);
    if (keyword == obj::kNote && with_notes_ && !notes_.read(line, model_.triangles.size()))
      refuse("a note \"#:\" that says nothing we know");
  }

  void vertex(std::string_view line) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = next_word(line);
      ParsedNumber number;
      if (word.empty() || parse_number_at(word.data(), word.data() + word.size(), number) !=
                              word.data() + word.size())
        refuse("a vertex needs three numbers");
      p[k] = number.value;
    }
    if (!is_finite(p)) refuse("a vertex is not finite");
    if (model_.vertices.size() == std::numeric_limits<uint32_t>::max())
      refuse("more than 2^32 vertices");
    model_.vertices.push_back(p);
  }

  // Corners are v, v/vt, v//vn or v/vt/vn, counted from 1, or back from the last vertex when
  // negative.
  void read_corners(std::string_view line) {
    polygon_.clear();
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      int64_t index = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
      if (error != std::errc() || (end != word.data() + word.size() && *end != '/'))
        refuse("a corner of a face is no vertex number");
      const auto count = static_cast<int64_t>(model_.vertices.size());
      if (index < -count || index > count || index == 0)
        refuse("a face names a vertex that is not there");
      polygon_.push_back(static_cast<uint32_t>(index > 0 ? index - 1 : count + index));
    }
  }

  void face(std::string_view line) {
    read_corners(line);
    if (polygon_.size() < 3) refuse("a face needs three corners");
    if (as_faces_) return planar_face();
    append_polygon(model_, polygon_, polygons_);
    if (polygons_ < std::numeric_limits<uint32_t>::max()) ++polygons_;
    group_of_triangle_.resize(model_.triangles.size(), group_);
  }

  // Polygons without area are left out.
  void planar_face() {
    if (model_.parts.empty()) group("default");
    Face face;
    face.part = group_;
    face.id = static_cast<uint32_t>(
        std::min<size_t>(model_.faces.size(), std::numeric_limits<uint32_t>::max()));
    face.first_ring = model_.rings.size();
    face.ring_count = 1;
    model_.rings.push_back({model_.corners.size(), polygon_.size()});
    model_.corners.insert(model_.corners.end(), polygon_.begin(), polygon_.end());
    if (measure_face(model_, face)) {
      model_.faces.push_back(face);
    } else {
      model_.corners.resize(model_.corners.size() - polygon_.size());
      model_.rings.pop_back();
    }
  }

  void polyline(std::string_view line) {
    read_corners(line);
    notes_.line(polygon_);
  }

  void group(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    const std::string name = name_from_file(line, "default");
    const auto [entry, added] =
        groups_.try_emplace(name, static_cast<uint32_t>(model_.parts.size()));
    if (added) model_.parts.push_back({name, "", kNoParent});
    group_ = entry->second;
  }

  const ByteSource& source_;
  Task& task_;
  LineReader lines_;
  Model model_;
  std::vector<uint32_t> polygon_, group_of_triangle_;
  std::map<std::string, uint32_t> groups_;
  uint32_t group_ = 0, polygons_ = 0;
  bool as_faces_, with_notes_;
  obj::Notes notes_;
};

}  // namespace

Model read_obj(const ByteSource& source, const ReadSettings& settings, Task& task) {
  ProgressSpan span(task, 0, 0.99, "reading OBJ");
  return ObjReader(source, settings.polygons, task).run();
}

}  // namespace jalon
