// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/field.h"
#include "cloud/sections/section_lines.h"
#include "cloud/sections/section_planes.h"

namespace jalon {

/// One cut through a cloud.
struct Section {
  SectionPlane plane;
  std::vector<SectionLine> lines;
  uint64_t points = 0;  ///< within half the thickness of the plane
  double cell_m = 0;    ///< that they were thinned by
};

/// What the sections are across; it tells their names, and how they are drawn.
enum class SectionKind { kHeight, kDirection, kAlignment };

struct Sections {
  SectionKind kind = SectionKind::kHeight;
  std::vector<Section> sections;  ///< by their place
  SharedText crs;                 ///< the cloud's
  /// "Z 12.500", "D 3.000", "STATION 25.000": as many decimals for all as tell them apart.
  std::string name(size_t section) const;
};

/// Parameter table of operation "sections".
std::span<const ParamRow> section_rows();
/// Cuts a cloud: across the direction of the settings, or across the alignment where it has points. The same bits for
/// any order of the points and any number of threads. Error(kInsufficientData) for a cloud without points.
Sections cut_sections(const Cloud& cloud, std::span<const Vec3> alignment,
                      const SectionSettings& settings, Task& task);

/// One row a section, a line, a vertex; columns as told in jalon/sections.h.
FieldTable section_table(const Sections& sections);
FieldTable section_line_table(const Sections& sections);
FieldTable section_vertex_table(const Sections& sections);

}  // namespace jalon
