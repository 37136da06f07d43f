// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/json_reader.h"
#include "base/text_number.h"
#include "report/pages/html_model.h"
#include "report/pages/plane_precision.h"

namespace jalon {

namespace {

// What was told of the scanner, without the influences that are left out.
void add_scanner(Page& page, const Notes& notes) {
  std::vector<std::pair<std::string, std::string>> pairs;
  const std::vector<JsonValue> values = read_json(notes.scanner_json);
  for (const JsonValue& value : JsonChildren(values[0]))
    if (value.is_number() && value.number != 0) pairs.emplace_back(value.name, value.text);
  page.note("The scanner, as told:");
  add_pairs(page, pairs);
}

void add_row(Page& page, const Segment& s, const PropagatedPlane* scanner) {
  const PlanePrecision precision = plane_precision(s.fit);
  page.html().open("tr");
  page.number(std::to_string(s.label));
  page.number(std::to_string(s.fit.n));
  page.number(text_of(1000 * s.fit.sigma, 2));
  page.number(text_of(1000 * precision.sigma_normal_rad, 4));
  page.number(text_of(1000 * precision.sigma_offset_m, 3));
  if (scanner != nullptr) {
    const bool is_known = std::isfinite(scanner->sigma_prior_m);
    page.number(is_known ? text_of(1000 * scanner->sigma_prior_m, 2) : "");
    page.number(is_known ? text_of(scanner->variance_factor, 3) : "");
  }
  page.html().close();
}

}  // namespace

void add_precision(Page& page, const Segmentation& segmentation, const Notes& notes, Task& task) {
  if (plane_count(segmentation.segments) == 0) return;
  const std::vector<PropagatedPlane> scanner = scanner_planes(segmentation, notes, task);
  page.heading("Precision");
  if (!scanner.empty()) add_scanner(page, notes);
  std::vector<const char*> names{"plane", "points", "\xCF\x83 of a point (mm)",
                                 "\xCF\x83 of the normal (mrad)", "\xCF\x83 of the place (mm)"};
  if (!scanner.empty())
    names.insert(names.end(), {"\xCF\x83 of a point by the scanner (mm)", "variance factor"});
  page.open_table(names);
  for (size_t i = 0; i < segmentation.segments.size(); ++i) {
    if (i % 256 == 0) task.checkpoint(0);
    const Segment& s = segmentation.segments[i];
    if (s.has_plane()) add_row(page, s, scanner.empty() ? nullptr : &scanner[i]);
  }
  page.close_table();
  page.note(
      "From the least-squares adjustment of each plane. \xCF\x83 of a point: distance from the "
      "plane; of the "
      "normal: in the direction in which it is least certain; of the place: along the normal, at "
      "the middle of "
      "the points. Errors common to all points (registration, scanner constants) are not in these "
      "figures.");
  if (!scanner.empty())
    page.note(
        "By the scanner: what its ranges and angles make of a point along the normal. Variance "
        "factor: squared "
        "distances of the points from the plane over their variances by the scanner; 1 where both "
        "agree, more "
        "where the surface is rougher than the scanner's noise.");
}

}  // namespace jalon
