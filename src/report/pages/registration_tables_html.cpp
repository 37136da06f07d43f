// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/registration_tables_html.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text_number.h"
#include "geometry/rigid_motion.h"
#include "report/pages/html_model.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

namespace {

constexpr size_t kMostPairs = 1000;  // that a reader looks at; the CSV has them all
constexpr double kDegrees = 180 / std::numbers::pi;

std::string known(double value, int decimals) {
  return std::isfinite(value) ? text_of(value, decimals) : "-";
}

std::string vector_text(const Vec3& v, int decimals) {
  return "(" + known(v.x, decimals) + ", " + known(v.y, decimals) + ", " + known(v.z, decimals) +
         ")";
}

// Lengths in millimetres, other numbers with the digits that tell them apart.
std::string cell_text(const Column& column, size_t row) {
  std::string out;
  for (uint32_t k = 0; k < column.info().components; ++k) {
    const double value = column.number(row, k);
    const bool is_length = column.info().unit == "m";
    const int decimals = !is_floating(column.info().type) ? 0 : is_length ? 2 : 3;
    out += (k > 0 ? ", " : "") + known(is_length ? 1000 * value : value, decimals);
  }
  return out;
}

// A turn, a shift, or both, as unit vectors of what is there.
std::string direction_text(const Column& directions, size_t row, double extent_m) {
  Vec3 turn, shift;
  for (uint32_t k = 0; k < 3; ++k) {
    turn[static_cast<int>(k)] = extent_m * directions.number(row, k);
    shift[static_cast<int>(k)] = directions.number(row, k + 3);
  }
  const double turned = norm(turn), shifted = norm(shift);
  constexpr double kSlight = 0.3;  // of the unit vector: a tenth of its square
  std::string out;
  if (shifted > kSlight) out = "shift along " + vector_text(shift / shifted, 2);
  if (turned > kSlight)
    out += (out.empty() ? "" : " with ") + ("turn about " + vector_text(turn / turned, 2));
  return out;
}

}  // namespace

std::string outcome_text(const Registration& r) {
  const std::string after = " after " + grouped(r.iterations) + " iterations";
  switch (r.stopped) {
    case StopReason::kConverged: {
      const std::string open =
          " " + std::to_string(r.unobservable) + " of six directions are not fixed by the data.";
      return "Converged" + (r.iterations > 0 ? after : std::string()) + " on " + grouped(r.pairs) +
             " pairs; rms of their residuals " + known(1000 * r.rms_m, 3) + " mm." +
             (r.unobservable > 0 ? open : "");
    }
    case StopReason::kIterationLimit:
      return "Not converged" + after + ": the limit of iterations.";
    case StopReason::kTooFewPairs:
      return "Stopped" + after + ": what both have in common does not carry the pose.";
    case StopReason::kAmbiguous:
      return "Ambiguous: a clearly different pose fits about as well.";
    case StopReason::kNothingFound:
      break;
  }
  return "Nothing found: no pose explains both.";
}

void add_pose(Page& page, const Registration& r) {
  page.heading("Pose");
  auto& html = page.html();
  html.open("table").open("tbody");
  for (size_t i = 0; i < 4; ++i) {
    html.open("tr");
    for (size_t j = 0; j < 4; ++j)
      page.number(i == 3 ? (j == 3 ? "1" : "0") : text_of(r.pose.m[4 * i + j], j == 3 ? 6 : 12));
    html.close();
  }
  html.close().close();
  const Vec3 turn = rotation_vector(r.pose);
  const double angle = norm(turn);
  const auto sigma = [&](size_t k) { return std::sqrt(r.covariance[7 * k]); };
  std::vector<std::pair<std::string, std::string>> pairs{
      {"turn", known(kDegrees * angle, 6) + "\xC2\xB0 about " +
                   vector_text(angle > 0 ? turn / angle : turn, 4)},
      {"shift of the centre (m)", vector_text(r.centre - inverse(r.pose).point(r.centre), 5)},
      {"centre, in the reference (m)", vector_text(r.centre, 3)},
      {"\xCF\x83 of the turn about x, y, z (\xC2\xB0)",
       vector_text({kDegrees * sigma(0), kDegrees * sigma(1), kDegrees * sigma(2)}, 6)},
      {"\xCF\x83 of the centre in x, y, z (mm)",
       vector_text({1000 * sigma(3), 1000 * sigma(4), 1000 * sigma(5)}, 3)}};
  if (r.scale != 1) pairs.emplace_back("scale", known(r.scale, 9));
  add_pairs(page, pairs);
  page.note("Maps coordinates of the moving into the reference's (4 x 4, metres).");
}

void add_search(Page& page, const Registration& r) {
  if (r.summary.find("score") == nullptr) return;
  const auto percent = [&](const char* column) {
    return known(100 * r.summary.require(column).number(0), 1) + " %";
  };
  page.heading("The search for the start");
  add_pairs(page, {{"score of the pose", percent("score")},
                   {"best score of a clearly different pose", percent("second_score")},
                   {"share of the moving surface on the reference", percent("overlap_moving")},
                   {"share of the reference's on the moving one", percent("overlap_reference")},
                   {"salient places in common that look alike", percent("likeness")}});
  page.note(
      "Score: overlap of both times likeness. The more the second one falls behind, the surer the "
      "pose.");
}

void add_directions(Page& page, const Registration& r) {
  const Column* directions = r.directions.find("direction");
  if (directions == nullptr) return;
  page.heading("What fixes the pose");
  auto& html = page.html();
  page.open_table({"direction", "\xCF\x83 (mm)", "fixed by the data"});
  for (size_t i = 0; i < directions->count(); ++i) {
    html.open("tr");
    html.element("td", {}, direction_text(*directions, i, r.extent_m));
    page.number(known(1000 * r.directions.require("sigma").number(i), 3));
    html.element("td", {},
                 r.directions.require("observable").number(i) != 0 ? "yes" : "no: as at the start");
    html.close();
  }
  page.close_table();
  page.note(
      "Principal directions of the pose, the weakest first; turns about the centre count as what "
      "they move at " +
      known(r.extent_m, 2) + " m from it.");
}

void add_pairs_table(Page& page, const Registration& r) {
  const size_t rows = r.residuals.size() > 0 ? r.residuals.at(0)->count() : 0;
  if (rows == 0 || rows > kMostPairs) return;
  page.heading("Residuals");
  std::vector<std::string> names{"target"};
  for (const ColumnPtr& column : r.residuals) {
    const std::string unit = column->info().unit == "m" ? "mm" : column->info().unit;
    names.push_back(column->info().name + (unit.empty() ? "" : " (" + unit + ")"));
  }
  std::vector<const char*> heads;
  for (const std::string& name : names) heads.push_back(name.c_str());
  page.open_table(heads);
  for (size_t i = 0; i < rows; ++i) {
    page.html().open("tr");
    page.foreign("td", i < r.pair_names.size() && !r.pair_names[i].empty() ? r.pair_names[i]
                                                                           : std::to_string(i + 1));
    for (const ColumnPtr& column : r.residuals) page.number(cell_text(*column, i));
    page.html().close();
  }
  page.close_table();
}

}  // namespace jalon
