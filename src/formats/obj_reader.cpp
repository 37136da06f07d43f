// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <limits>
#include <map>

#include "base/error.h"
#include "formats/fast_number.h"
#include "formats/line_reader.h"
#include "formats/polygon_triangles.h"
#include "formats/readers.h"
#include "formats/utf8.h"

namespace jalon {

namespace {

constexpr size_t kTicks = 4096;  // lines between two looks at the task

class ObjReader {
 public:
  ObjReader(const ByteSource& source, Task& task) : source_(source), task_(task), lines_(source) {}

  Model run() {
    std::string_view line;
    std::string joined;
    while (lines_.next(line)) {
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
    // Without groups every polygon is a face of its own.
    if (!groups_.empty()) model_.triangle_faces.swap(group_of_triangle_);
    return std::move(model_);
  }

 private:
  [[noreturn]] void refuse(const char* reason) const {
    fail(Status::kFormat, "%.400s: line %llu: %s", source_.path().c_str(),
         static_cast<unsigned long long>(lines_.number()), reason);
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
    if (keyword == "g" || keyword == "o") group(line);
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
  void face(std::string_view line) {
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
    if (polygon_.size() < 3) refuse("a face needs three corners");
    append_polygon(model_, polygon_, polygons_);
    if (polygons_ < std::numeric_limits<uint32_t>::max()) ++polygons_;
    group_of_triangle_.resize(model_.triangles.size(), group_);
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
};

}  // namespace

Model read_obj(const ByteSource& source, Task& task) {
  Span span(task, 0, 0.99, "reading OBJ");
  return ObjReader(source, task).run();
}

}  // namespace jalon
