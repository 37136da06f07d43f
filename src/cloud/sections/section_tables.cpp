// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/table_columns.h"
#include "cloud/sections/sections.h"

namespace jalon {

namespace {

struct LineRow {
  uint32_t section = 0;
  uint64_t first = 0;  ///< of its vertices
  const SectionLine* line = nullptr;
};
struct VertexRow {
  uint32_t section = 0, line = 0;
  Vec2 uv;
  Vec3 xyz;
};

std::vector<LineRow> line_rows(const Sections& sections) {
  std::vector<LineRow> rows;
  uint64_t first = 0;
  for (uint32_t s = 0; s < sections.sections.size(); ++s)
    for (const SectionLine& line : sections.sections[s].lines) {
      rows.push_back({s, first, &line});
      first += line.vertices.size();
    }
  return rows;
}

std::vector<VertexRow> vertex_rows(const Sections& sections) {
  std::vector<VertexRow> rows;
  uint32_t number = 0;
  for (uint32_t s = 0; s < sections.sections.size(); ++s)
    for (const SectionLine& line : sections.sections[s].lines) {
      for (const Vec2& p : line.vertices)
        rows.push_back({s, number, p, sections.sections[s].plane.place(p)});
      ++number;
    }
  return rows;
}

void put(const Vec3& v, double* out) { out[0] = v.x, out[1] = v.y, out[2] = v.z; }

// Of all lines of a section, by their points; without any nothing was measured.
double rms_of(const Section& section) {
  double sum = 0, n = 0;
  for (const SectionLine& line : section.lines) {
    sum += line.rms_m * line.rms_m * static_cast<double>(line.points);
    n += static_cast<double>(line.points);
  }
  return n > 0 ? std::sqrt(sum / n) : kNaN;
}

template <class F>
auto total(const Section& section, F&& of) {
  decltype(of(section.lines[0])) sum{};
  for (const SectionLine& line : section.lines) sum += of(line);
  return sum;
}

}  // namespace

FieldTable section_table(const Sections& sections) {
  const auto& rows = sections.sections;
  FieldTable table;
  add_column<double>(table, rows, "at", "m", "height, place along the direction, or station",
                     [](const Section& s) { return s.plane.at_m; });
  add_columns<double, 3>(table, rows, "origin", "m", "of offsets in the plane",
                         [](const Section& s, double* out) { put(s.plane.origin, out); });
  add_columns<double, 3>(table, rows, "axis_u", "", "to the right",
                         [](const Section& s, double* out) { put(s.plane.u, out); });
  add_columns<double, 3>(table, rows, "axis_v", "", "upward in the drawing",
                         [](const Section& s, double* out) { put(s.plane.v, out); });
  add_column<uint64_t>(table, rows, "points", "", "points within half the thickness",
                       [](const Section& s) { return s.points; });
  add_column<uint64_t>(table, rows, "points_on_lines", "", "points that lines were made of",
                       [](const Section& s) {
                         return total(s, [](const SectionLine& line) { return line.points; });
                       });
  add_column<uint64_t>(table, rows, "lines", "", "lines",
                       [](const Section& s) { return s.lines.size(); });
  add_column<double>(table, rows, "length", "m", "length of the lines", [](const Section& s) {
    return total(s, [](const SectionLine& line) { return line.length_m; });
  });
  add_column<double>(table, rows, "rms", "m", "of the points' distances from their lines", rms_of);
  add_column<double>(table, rows, "max", "m", "largest distance of a point from its line",
                     [](const Section& s) {
                       double largest = s.lines.empty() ? kNaN : 0;
                       for (const SectionLine& line : s.lines)
                         largest = std::max(largest, line.max_m);
                       return largest;
                     });
  add_column<double>(table, rows, "cell", "m", "side of the cells that the points were thinned by",
                     [](const Section& s) { return s.cell_m; });
  return table;
}

FieldTable section_line_table(const Sections& sections) {
  const std::vector<LineRow> rows = line_rows(sections);
  FieldTable table;
  add_column<uint32_t>(table, rows, "section", "", "row of the section",
                       [](const LineRow& r) { return r.section; });
  add_column<uint64_t>(table, rows, "first", "", "row of the first vertex",
                       [](const LineRow& r) { return r.first; });
  add_column<uint32_t>(table, rows, "vertices", "", "vertices",
                       [](const LineRow& r) { return r.line->vertices.size(); });
  add_column<uint8_t>(table, rows, "closed", "", "1: the last vertex is joined to the first",
                      [](const LineRow& r) { return r.line->is_closed ? 1 : 0; });
  add_column<uint64_t>(table, rows, "points", "", "points that it was made of",
                       [](const LineRow& r) { return r.line->points; });
  add_column<double>(table, rows, "length", "m", "length",
                     [](const LineRow& r) { return r.line->length_m; });
  add_column<double>(table, rows, "rms", "m", "of the points' distances from it",
                     [](const LineRow& r) { return r.line->rms_m; });
  add_column<double>(table, rows, "max", "m", "largest distance of a point from it",
                     [](const LineRow& r) { return r.line->max_m; });
  return table;
}

FieldTable section_vertex_table(const Sections& sections) {
  const std::vector<VertexRow> rows = vertex_rows(sections);
  FieldTable table;
  add_column<uint32_t>(table, rows, "section", "", "row of the section",
                       [](const VertexRow& r) { return r.section; });
  add_column<uint32_t>(table, rows, "line", "", "row of the line",
                       [](const VertexRow& r) { return r.line; });
  add_columns<double, 3>(table, rows, "xyz", "m", "in space",
                         [](const VertexRow& r, double* out) { put(r.xyz, out); });
  add_columns<double, 2>(table, rows, "uv", "m", "from the section's origin along its axes",
                         [](const VertexRow& r, double* out) { out[0] = r.uv.u, out[1] = r.uv.v; });
  return table;
}

}  // namespace jalon
