// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/equal_vertices.h"
#include "formats/files/endian.h"
#include "formats/files/fast_number.h"
#include "formats/files/utf8.h"
#include "formats/stl/layout.h"
#include "formats/stl/stl.h"
#include "formats/text/line_reader.h"

namespace jalon {

namespace {

constexpr size_t kTicks = 4096;  // triangles or lines between two looks at the task

uint32_t add_part(Model& model, std::string_view name) {
  model.parts.push_back({name_from_file(name, "mesh"), "mesh", kNoParent});
  return static_cast<uint32_t>(model.parts.size() - 1);
}

// "Jalon, metres, add X Y Z" of our own writer; zero for all other files.
Vec3 shift_of(std::string_view header) {
  constexpr std::string_view kWord = stl::kShiftWord;
  Vec3 shift;
  if (!header.starts_with(kWord)) return shift;
  header.remove_prefix(kWord.size());
  for (int k = 0; k < 3; ++k) {
    const size_t begin = header.find_first_not_of(' ');
    if (begin == std::string_view::npos) return {};
    const size_t end = std::min(header.find(' ', begin), header.size());
    if (!parse_number(header.substr(begin, end - begin), shift[k]) || !std::isfinite(shift[k]))
      return {};
    header.remove_prefix(end);
  }
  return shift;
}

Model read_binary(const ByteSource& source, Task& task) {
  char head[stl::kHeaderBytes + stl::kCountBytes];
  source.read(0, head, sizeof head);
  const uint64_t count = load<uint32_t>(head + stl::kHeaderBytes);
  const Vec3 shift = shift_of({head, stl::kHeaderBytes});
  Model model;
  add_part(model, "mesh");
  EqualVertices vertices(model);
  constexpr uint64_t kBlock = 4096;
  std::vector<char> records(std::min(count, kBlock) * stl::kRecordBytes);
  for (uint64_t first = 0; first < count; first += kBlock) {
    task.checkpoint(static_cast<double>(first) / static_cast<double>(count));
    const uint64_t n = std::min(kBlock, count - first),
                   offset = sizeof head + first * stl::kRecordBytes;
    source.read(offset, records.data(), n * stl::kRecordBytes);
    for (uint64_t i = 0; i < n; ++i) {
      std::array<uint32_t, 3> triangle;
      for (size_t k = 0; k < 3; ++k) {
        const char* at = records.data() + i * stl::kRecordBytes + 12 * (k + 1);
        const Vec3 p = Vec3{load<float>(at), load<float>(at + 4), load<float>(at + 8)} + shift;
        if (!is_finite(p))
          source.refuse(offset + i * stl::kRecordBytes, "triangle %llu is not finite",
                        static_cast<unsigned long long>(first + i));
        triangle[k] = vertices.add(p);
      }
      model.triangles.push_back(triangle);
    }
  }
  model.triangle_faces.assign(model.triangles.size(), 0);
  return model;
}

/// solid NAME, facets of one loop of three vertices each, endsolid; several solids make several parts.
class AsciiStl {
 public:
  AsciiStl(const ByteSource& source, Task& task)
      : source_(source), task_(task), lines_(source), vertices_(model_) {}

  Model run() {
    std::string_view line;
    while (lines_.next(line)) {
      if (lines_.number() % kTicks == 0) task_.checkpoint(lines_.fraction());
      statement(line);
    }
    if (model_.triangles.empty()) refuse("there are no triangles");
    if (corners_ != 0) refuse("the file ends inside a facet");
    return std::move(model_);
  }

 private:
  [[noreturn]] void refuse(const char* reason) const {
    fail(Status::kFormat, "%.400s: line %llu: %s", source_.path().c_str(),
         static_cast<unsigned long long>(lines_.number()), reason);
  }

  static std::string_view next_word(std::string_view& line) {
    const size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    const size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
  }

  void statement(std::string_view line) {
    const std::string keyword = lower(next_word(line).substr(0, 16));
    if (keyword == "vertex") return vertex(line);
    if (keyword == "solid") {
      name_ = name_from_file(line, "mesh");
      in_part_ = false;
    } else if (keyword == "facet") {
      if (corners_ != 0) refuse("a facet inside a facet");
    } else if (keyword == "endloop" || keyword == "endfacet") {
      if (corners_ != 0) refuse("a facet needs three vertices");
    } else if (!keyword.empty() && keyword != "outer" && keyword != "endsolid") {
      refuse("this is no statement of an STL file");
    }
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
    triangle_[corners_++] = vertices_.add(p);
    if (corners_ < 3) return;
    corners_ = 0;
    if (!in_part_) part_ = add_part(model_, name_);  // solids without facets are no parts
    in_part_ = true;
    model_.triangles.push_back(triangle_);
    model_.triangle_faces.push_back(part_);
  }

  const ByteSource& source_;
  Task& task_;
  LineReader lines_;
  Model model_;
  EqualVertices vertices_;
  std::array<uint32_t, 3> triangle_{};
  size_t corners_ = 0;
  std::string name_ = "mesh";
  bool in_part_ = false;
  uint32_t part_ = 0;
};

}  // namespace

bool is_binary_stl(const ByteSource& source) {
  char head[stl::kHeaderBytes + stl::kCountBytes];
  if (source.read_some(0, head, sizeof head) < sizeof head) return false;
  return source.size() - sizeof head ==
         uint64_t{load<uint32_t>(head + stl::kHeaderBytes)} * stl::kRecordBytes;
}

Model read_stl(const ByteSource& source, const ReadSettings&, Task& task) {
  ProgressSpan span(task, 0, 0.99, "reading STL");
  // Many binary files begin with "solid" as well: their size tells.
  if (is_binary_stl(source)) return read_binary(source, task);
  char start[6] = {};
  source.read_some(0, start, 5);
  if (lower(start) == "solid") return AsciiStl(source, task).run();
  source.refuse(std::min<uint64_t>(source.size(), stl::kHeaderBytes),
                "neither \"solid\" nor a number of triangles that fits the size of the file");
}

}  // namespace jalon
