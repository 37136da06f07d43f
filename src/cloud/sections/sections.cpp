// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/sections.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/text_number.h"
#include "cloud/sections/slid_points.h"

namespace jalon {

namespace {

constexpr int kLeastDecimals = 3, kMostDecimals = 9;  // of the places in names: a millimetre

// Origins: thickness and gap as far as the points of a scan from 20 m stand apart; the tolerance four sigma of a 5 mm
// scanner.
constexpr auto kSectionRows = setting_rows(
    doubles_row<&SectionSettings::direction>(
        "direction", -1, 1, "1", "",
        "What the cloud is cut across: x, y, z; 0, 0, 1 gives level sections. An alignment has no "
        "use for it."),
    doubles_row<&SectionSettings::at_m>(
        "at_m", -1e9, 1e9, "m", "",
        "Where to cut: heights, places along the direction, or stations of the alignment."),
    number_row<&SectionSettings::step_m>(
        "step_m", 0, 1e6, "m", "",
        "Distance from section to section: cuts also at all multiples of it, as far as the cloud "
        "or the alignment goes; 0 = at_m alone, or each metre where that is empty."),
    number_row<&SectionSettings::thickness_m>(
        "thickness_m", 1e-6, 1000, "m", "",
        "Points within half of it on either side are taken into the section."),
    number_row<&SectionSettings::tolerance_m>(
        "tolerance_m", 1e-6, 100, "m", "",
        "Farthest that a line may be simplified; four sigma of the points at least, or the lines "
        "follow the noise."),
    number_row<&SectionSettings::gap_m>("gap_m", 1e-6, 1000, "m", "",
                                        "A line breaks off where there is no point for so long."),
    number_row<&SectionSettings::reach_m>(
        "reach_m", 0, 1e6, "m", "",
        "Largest distance from an alignment, to the left and right of it, that its sections show; "
        "0 = no end."),
    number_row<&SectionSettings::min_length_m>("min_length_m", 0, 1e6, "m", "",
                                               "Lines of less length are left out."));

SectionKind kind_of(const SectionSettings& settings, bool has_alignment) {
  if (has_alignment) return SectionKind::kAlignment;
  const std::vector<double>& d = settings.direction;
  return d.size() == 3 && d[0] == 0 && d[1] == 0 && d[2] > 0 ? SectionKind::kHeight
                                                             : SectionKind::kDirection;
}

const char* prefix_of(SectionKind kind) {
  if (kind == SectionKind::kAlignment) return "STATION ";
  return kind == SectionKind::kHeight ? "Z " : "D ";
}

}  // namespace

std::span<const ParamRow> section_rows() { return kSectionRows; }

std::string Sections::name(size_t section) const {
  const auto text = [&](size_t k, int decimals) {
    return text_of(sections[k].plane.at_m, decimals);
  };
  int decimals = kLeastDecimals;
  const auto shared = [&] {  // with a neighbour: places ascend
    return (section > 0 && text(section - 1, decimals) == text(section, decimals)) ||
           (section + 1 < sections.size() &&
            text(section + 1, decimals) == text(section, decimals));
  };
  while (decimals < kMostDecimals && shared()) ++decimals;
  return prefix_of(kind) + text(section, decimals);
}

// 1. planes; 2. the points near each; 3. these onto it along their surfaces, and lines through them,
// section by section.
Sections cut_sections(const Cloud& cloud, std::span<const Vec3> alignment,
                      const SectionSettings& settings, Task& task) {
  if (cloud.size() == 0) fail(Status::kInsufficientData, "the cloud has no points to cut through");
  const bool has_alignment = !alignment.empty();
  Sections out;
  out.kind = kind_of(settings, has_alignment);
  out.crs = cloud.crs;
  std::vector<SectionPlane> planes;
  std::vector<std::vector<uint32_t>> points;
  {
    ProgressSpan span(task, 0, 0.4, "cutting");
    planes = has_alignment ? planes_along_alignment(alignment, settings)
                           : planes_along_direction(cloud, settings, task);
    points = points_of_planes(cloud, planes, settings.thickness_m,
                              has_alignment ? settings.reach_m : 0, task);
  }
  ProgressSpan span(task, 0.4, 1, "drawing lines");
  out.sections.resize(planes.size());
  parallel_for(task, planes.size(), 1, [&](size_t k, size_t) {
    Section& section = out.sections[k];
    section.plane = planes[k];
    section.points = points[k].size();
    std::vector<Vec3> near;
    near.reserve(points[k].size());
    for (const uint32_t i : points[k]) near.push_back(planes[k].near(cloud.point(i)));
    const std::vector<Vec2> flat =
        slid_points(std::move(near), settings.thickness_m, settings.tolerance_m, task);
    section.lines = section_lines(flat, settings, section.cell_m, task);
  });
  return out;
}

}  // namespace jalon
