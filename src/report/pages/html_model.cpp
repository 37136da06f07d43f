// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/html_model.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"
#include "model/part_classes.h"
#include "report/names/evidence_name.h"
#include "report/names/no_data.h"
#include "report/names/part_tree.h"

namespace jalon {

namespace {

// Nothing for what is not known.
std::string metres_of_html_model(double value_m, int decimals = 2) {
  return std::isfinite(value_m) ? text_of(value_m, decimals) : std::string();
}
std::string millimetres(double value_m) {
  return std::isfinite(value_m) ? text_of(1000 * value_m, 2) : std::string();
}

void add_types(Page& page, const OpeningList& openings) {
  page.open_table(
      {"type", "class", "width (m)", "height (m)", "form", "number", "of these copied"});
  for (const OpeningType& type : openings.types) {
    page.html().open("tr");
    page.html().element("td", {}, type.tag);
    page.foreign("td", type.part_class);
    page.number(text_of(type.width_m, 2));
    page.number(text_of(type.height_m, 2));
    page.html().element("td", {}, type.arched ? "with arc" : "straight");
    page.number(std::to_string(type.count));
    page.number(type.copies > 0 ? std::to_string(type.copies) : "");
    page.html().close();
  }
  page.close_table();
}

bool is_known(const OpeningList& openings, double OpeningRow::*value) {
  return std::any_of(openings.rows.begin(), openings.rows.end(),
                     [&](const OpeningRow& row) { return std::isfinite(row.*value); });
}

void add_each(Page& page, const Model& model, const OpeningList& openings) {
  page.open_table({"opening", "class", "confidence", "type", "width (m)", "\xCF\x83 (mm)",
                   "height (m)", "\xCF\x83 (mm)", "depth (m)", "\xCF\x83 (mm)", "known from"});
  for (const OpeningRow& row : openings.rows) {
    page.html().open("tr");
    page.foreign("td", row.name);
    page.foreign("td", row.part_class);
    page.number(metres_of_html_model(row.class_confidence, 2));
    page.html().element("td", {}, openings.types[row.type].tag);
    page.number(text_of(row.width_m, 3));
    page.number(millimetres(row.sigma_width_m));
    page.number(text_of(row.height_m, 3));
    page.number(millimetres(row.sigma_height_m));
    page.number(metres_of_html_model(row.depth_m, 3));
    page.number(millimetres(row.sigma_depth_m));
    page.foreign("td", row.copied_from != kNoParent
                           ? "copy of " + part_label(model, row.copied_from)
                           : std::string(evidence_name(row.evidence)));
    page.html().close();
  }
  page.close_table();
}

}  // namespace

void add_pairs(Page& page, const std::vector<std::pair<std::string, std::string>>& pairs) {
  auto& html = page.html();
  html.open("table").open("tbody");
  for (const auto& [name, value] : pairs) {
    html.open("tr");
    page.foreign("th", name);
    page.foreign("td", value);
    html.close();
  }
  html.close().close();
}

void add_openings(Page& page, const Model& model, const OpeningList& openings) {
  if (openings.rows.empty()) return;
  page.heading("Openings");
  add_types(page, openings);
  add_each(page, model, openings);
  page.note(
      "Width and height of the upright box in the plane of the wall, depth behind it. Openings of "
      "one type agree "
      "within " +
      text_of(1000 * kTypeTolerance_m, 0) + " mm.");
  if (is_known(openings, &OpeningRow::sigma_width_m) ||
      is_known(openings, &OpeningRow::sigma_depth_m))
    page.note(
        "\xCF\x83: standard deviation by propagation from the covariances of corners and planes; "
        "that of a side "
        "counts once, however many corners hold it.");
}

void add_parts(Page& page, const Model& model) {
  if (model.parts.empty()) return;
  const PartTree tree(model);
  page.heading("Parts");
  page.open_table({"part", "class", "faces", "area (m\xC2\xB2)", "width (m)", "height (m)",
                   "depth (m)", "known from"});
  size_t reveals = 0;
  for (const PartTree::Step& step : tree.walk()) {
    const Part& part = model.parts[step.part];
    if (part.part_class == part_class::kReveal) {
      ++reveals;
      continue;
    }
    double area_m2 = 0;
    for (const size_t f : tree.faces()[step.part]) area_m2 += model.faces[f].area_m2;
    const size_t faces = tree.faces()[step.part].size();
    page.html().open("tr");
    page.html().open(
        "td",
        {{"style", "padding-left:" + text_of(0.6 + 1.2 * std::min(step.depth, 12u), 1) + "rem"}});
    page.html().element("bdi", {}, part_label(model, step.part)).close();
    page.foreign("td", part.part_class);
    page.number(faces > 0 ? std::to_string(faces) : "");
    page.number(faces > 0 ? text_of(area_m2, 2) : "");
    page.number(metres_of_html_model(part.width_m, 3));
    page.number(metres_of_html_model(part.height_m, 3));
    page.number(metres_of_html_model(part.depth_m, 3));
    page.foreign("td", part.copied_from != kNoParent
                           ? "copy of " + part_label(model, part.copied_from)
                           : std::string(evidence_name(part.evidence)));
    page.html().close();
  }
  page.close_table();
  if (const NoData no_data = no_data_of(model); no_data.count > 0)
    page.note("No data: " + std::to_string(no_data.count) + " places of the walls, " +
              text_of(no_data.area_m2, 2) + " m\xC2\xB2, " + text_of(100 * no_data.share(), 1) +
              " % of the walls with them, were not measured (hatched in the drawing).");
  if (reveals > 0)
    page.note("And " + std::to_string(reveals) + " reveals, each below its opening.");
}

}  // namespace jalon
