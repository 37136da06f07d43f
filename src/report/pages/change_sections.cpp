// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/change_sections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "report/names/told_numbers.h"
#include "report/pages/html_model.h"
#include "report/pictures/epochs_picture.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

namespace {

constexpr size_t kMostRows = 500;  // of changes in the page; the CSV has them all
constexpr const char* kClasses[] = {"",
                                    "appearance",
                                    "disappearance",
                                    "displacement",
                                    "displacement with overlap",
                                    "deformation",
                                    "deformation with overlap"};
// Around what changed: a share of its diagonal, and so much at least, that its place can be told.
constexpr double kAround = 0.3, kLeastAround_m = 0.3;

using Pairs = std::vector<std::pair<std::string, std::string>>;

std::string vector_text(const Column& column, size_t row, int decimals) {
  std::string out;
  for (uint32_t k = 0; k < column.info().components; ++k)
    out += (k > 0 ? ", " : "") + told_number(column.number(row, k), decimals);
  return out;
}

double length_of(const Column& column, size_t row) {
  return std::hypot(column.number(row, 0), column.number(row, 1), column.number(row, 2));
}

std::string class_of(const FieldTable& changes, size_t row) {
  return kClasses[std::min<size_t>(6, static_cast<size_t>(changes.require("class").number(row)))];
}

std::string both_of(const FieldTable& changes, const std::string& name, size_t row) {
  return told_number(changes.require(name + "_before").number(row)) + ", " +
         told_number(changes.require(name + "_after").number(row));
}

// Where it is now, else where it was.
std::string place_of(const FieldTable& changes, size_t row, int decimals) {
  const Column& after = changes.require("centroid_after");
  const bool is_there = std::isfinite(after.number(row, 0));
  return vector_text(is_there ? after : changes.require("centroid_before"), row, decimals);
}

void add_change_row(Page& page, const FieldTable& changes, size_t row) {
  page.html().element("td", {}, class_of(changes, row));
  page.number(text_of(changes.require("confidence").number(row), 2));
  page.number(both_of(changes, "area", row));
  page.number(both_of(changes, "volume", row));
  page.number(place_of(changes, row, 2));
  page.number(told_number(length_of(changes.require("displacement"), row)));
}

// With its standard deviation, where that is known.
std::string volume_of(const FieldTable& changes, size_t row) {
  const std::string volume = told_number(changes.require("volume").number(row));
  const Column* sigma = changes.find("volume_sigma");
  return sigma == nullptr ? volume : volume + " \xC2\xB1 " + told_number(sigma->number(row));
}

void add_region_row(Page& page, const FieldTable& changes, size_t row) {
  page.number(grouped(static_cast<uint64_t>(changes.require("points").number(row))));
  page.number(told_number(changes.require("area").number(row)));
  page.number(volume_of(changes, row));
  for (const char* name : {"mean", "extreme"})
    page.number(told_mm(changes.require(name).number(row)));
  page.number(vector_text(changes.require("centroid"), row, 2));
}

void add_motion(const FieldTable& changes, size_t row, Pairs& pairs) {
  const Column& way = changes.require("displacement");
  if (!std::isfinite(way.number(row, 0))) return;
  pairs.emplace_back("displacement (m)", vector_text(way, row, 4));
  std::string sigma;
  for (const uint32_t k : {21u, 28u, 35u})  // of the displacement, on the diagonal of 6 x 6
    sigma +=
        (k > 21 ? ", " : "") + told_mm(std::sqrt(changes.require("covariance").number(row, k)));
  pairs.emplace_back("its \xCF\x83 (mm)", sigma);
  if (const Column* turn = changes.find("rotation"))
    pairs.emplace_back("turned by (degrees)",
                       told_number(length_of(*turn, row) * 180 / std::numbers::pi, 2));
}

Pairs told_of_change(const FieldTable& changes, size_t row) {
  Pairs out{{"confidence", text_of(changes.require("confidence").number(row), 2)},
            {"changed area before, after (m\xC2\xB2)", both_of(changes, "area", row)},
            {"volume before, after (m\xC2\xB3)", both_of(changes, "volume", row)}};
  for (const char* epoch : {"before", "after"}) {
    const Column& centroid = changes.require(std::string("centroid_") + epoch);
    if (std::isfinite(centroid.number(row, 0)))
      out.emplace_back(std::string("centroid ") + epoch + " (m)", vector_text(centroid, row, 3));
  }
  add_motion(changes, row, out);
  return out;
}

Pairs told_of_region(const FieldTable& changes, size_t row) {
  return {{"area (m\xC2\xB2)", told_number(changes.require("area").number(row))},
          {"volume (m\xC2\xB3)", volume_of(changes, row)},
          {"mean, largest distance (mm)", told_mm(changes.require("mean").number(row)) + ", " +
                                              told_mm(changes.require("extreme").number(row))}};
}

double around(const std::vector<Vec3>& changed) {
  Box3 box;
  for (const Vec3& p : changed) box.add(p);
  return std::max(kLeastAround_m, kAround * norm(box.max - box.min));
}

}  // namespace

void add_change_table(Page& page, const FieldTable& changes) {
  const bool has_classes = changes.find("class") != nullptr;
  page.heading(has_classes ? "Changes" : "Change regions");
  const size_t rows = changes.size() == 0 ? 0 : changes.at(0)->count();
  if (rows == 0) return page.note("Nothing has changed by more than what was asked for.");
  if (has_classes)
    page.open_table({"No", "class", "confidence", "area (m\xC2\xB2)", "volume (m\xC2\xB3)",
                     "at (m)", "moved by (m)"});
  else
    page.open_table({"No", "points", "area (m\xC2\xB2)", "volume (m\xC2\xB3)", "mean (mm)",
                     "largest (mm)", "centroid (m)"});
  for (size_t i = 0; i < std::min(rows, kMostRows); ++i) {
    page.html().open("tr");
    page.number(std::to_string(i + 1));
    has_classes ? add_change_row(page, changes, i) : add_region_row(page, changes, i);
    page.html().close();
  }
  page.close_table();
  if (has_classes)
    page.note("Areas and volumes: before, after. At: where it is now, else where it was.");
  if (rows > kMostRows)
    page.note("The first " + std::to_string(kMostRows) + " of " + std::to_string(rows) + ".");
}

void add_change_pages(Page& page, const Comparison& forward, const Comparison* reverse,
                      const FieldTable& changes, std::span<const ChangePlace> places,
                      const DeviationScale& scale, Task& task) {
  const bool has_classes = changes.find("class") != nullptr;
  std::vector<EpochPanel> panels;
  if (reverse != nullptr) panels.push_back({"before: the reference", reverse});
  panels.push_back({"after: what was compared", &forward});
  // At once: each picture looks for its points in the whole cloud.
  std::vector<std::string> pictures(places.size());
  parallel_chunks(task, places.size(), [&](size_t k) {
    const std::vector<Vec3> changed = places[k].points(forward, reverse);
    if (!changed.empty()) pictures[k] = epochs_svg(panels, changed, around(changed), scale, task);
  });
  for (size_t k = 0; k < places.size(); ++k) {
    const ChangePlace& place = places[k];
    if (pictures[k].empty()) continue;
    page.html().open("section", {{"style", "break-before:page"}});
    page.heading((has_classes ? "Change " : "Region ") + std::to_string(place.row + 1) +
                 (has_classes ? ": " + class_of(changes, place.row) : ""));
    add_pairs(page, has_classes ? told_of_change(changes, place.row)
                                : told_of_region(changes, place.row));
    page.html().raw(pictures[k]);
    page.html().close();
  }
}

}  // namespace jalon
