// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/landslide_sections.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "compare/landslide/cell_table.h"
#include "report/names/told_numbers.h"
#include "report/pages/html_model.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

namespace {

constexpr const char* kToldOfLandslide[] = {"depletion",
                                            "depletion_sigma",
                                            "accumulation",
                                            "accumulation_sigma",
                                            "net",
                                            "net_sigma",
                                            "depletion_area",
                                            "accumulation_area",
                                            "boundary",
                                            "open_boundary",
                                            "measured_area",
                                            "unmeasured_reference",
                                            "unmeasured_compared",
                                            "unmeasured_both",
                                            "unmeasured_hidden",
                                            "unmeasured_beside_zones",
                                            "unmeasured_share",
                                            "cell"};

// Rows of the table of volumes, and of the table of what was not measured.
struct ToldVolume {
  const char *name, *volume, *sigma, *area;
};
constexpr ToldVolume kVolumes[] = {
    {"went down (depletion)", "depletion", "depletion_sigma", "depletion_area"},
    {"rose (accumulation)", "accumulation", "accumulation_sigma", "accumulation_area"},
    {"rose less went down", "net", "net_sigma", nullptr}};
struct ToldArea {
  const char *name, *area;
};
constexpr ToldArea kAreas[] = {
    {"measured in both epochs", "measured_area"},
    {"not measured in the reference alone", "unmeasured_reference"},
    {"not measured in the compared epoch alone", "unmeasured_compared"},
    {"not measured in either", "unmeasured_both"},
    {"of these in a scanner's shadow", "unmeasured_hidden"},
    {"of these beside a zone, which may go on there", "unmeasured_beside_zones"}};

}  // namespace

bool is_told_of_landslide(std::string_view name) {
  return std::any_of(std::begin(kToldOfLandslide), std::end(kToldOfLandslide),
                     [&](const char* told) { return name == told; });
}

void add_landslide(Page& page, const Comparison& comparison) {
  if (!is_landslide(comparison)) return;
  const auto number = [&](const char* name) { return comparison.summary.require(name).number(0); };
  auto& html = page.html();
  page.heading("Ground that moved");
  page.open_table({"", "volume (m\xC2\xB3)", "its \xCF\x83 (m\xC2\xB3)", "area (m\xC2\xB2)"});
  for (const ToldVolume& told : kVolumes) {
    html.open("tr");
    html.element("td", {}, told.name);
    page.number(told_number(number(told.volume), 2));
    page.number(told_number(number(told.sigma), 2));
    page.number(told.area != nullptr ? told_number(number(told.area), 1) : "");
    html.close();
  }
  page.close_table();
  page.note("Cells of " + told_number(number("cell"), 3) +
            " m. Volumes are of the cells that both epochs have measured, none is filled in; "
            "areas are across the direction along which movements are counted.");
  const double open = number("open_boundary");
  page.note("Boundary of the zones: " + told_number(number("boundary"), 1) + " m" +
            (open > 0 ? ", of which " + told_number(open, 1) +
                            " m run along ground that was not measured: there it is not known how "
                            "far the movement goes."
                      : ", all of it measured on both sides."));
  page.heading("What was not measured");
  page.open_table({"", "area (m\xC2\xB2)", "share (%)"});
  const double all = number("measured_area") + number("unmeasured_reference") +
                     number("unmeasured_compared") + number("unmeasured_both");
  for (const ToldArea& told : kAreas) {
    html.open("tr");
    html.element("td", {}, told.name);
    page.number(told_number(number(told.area), 1));
    page.number(told_number(100 * number(told.area) / all, 1));
    html.close();
  }
  page.close_table();
}

}  // namespace jalon
