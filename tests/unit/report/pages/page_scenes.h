// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/table_columns.h"
#include "compare/comparison.h"
#include "compare/summary.h"
#include "unit/report/markup.h"

/// Pages read back as tables of texts, and comparisons with given distances.
namespace page_scenes {

using namespace jalon;

using Row = std::vector<std::string>;  ///< texts of the cells, foreign ones without their <bdi>
using Table = std::vector<Row>;        ///< the heading's row first where there is one

/// The tables of a page behind the chapter of this heading up to the next chapter; "" = all.
inline std::vector<Table> tables_of(std::string_view html, std::string_view heading = "") {
  std::vector<Table> out;
  bool is_within = heading.empty();
  for (const markup::Tag& tag : markup::tags(html)) {
    if (tag.name == "h2" && !heading.empty()) is_within = tag.text_after == heading;
    if (!is_within) continue;
    if (tag.name == "table") out.emplace_back();
    if (tag.name == "tr" && !out.empty()) out.back().emplace_back();
    std::string text = tag.text_after;
    std::erase(text, '\n');  // behind tags that open
    const bool is_cell = tag.name == "td" || tag.name == "th";
    if (is_cell) out.back().back().push_back(text);
    if (tag.name == "bdi" && !out.empty() && !out.back().empty() && !out.back().back().empty())
      out.back().back().back() += text;
  }
  return out;
}

inline bool has(std::string_view html, std::string_view text) {
  return html.find(text) != std::string_view::npos;
}

/// The number behind a text, up to the next blank or tag; NaN without the text.
inline double number_after(std::string_view html, std::string_view text) {
  const size_t at = html.find(text);
  if (at == std::string_view::npos) return NAN;
  const std::string_view rest = html.substr(at + text.size());
  return markup::number(rest.substr(0, rest.find_first_of(" <,;")));
}

/// The numbers of a cell "1.00, 2.00".
inline std::vector<double> numbers_of(const std::string& cell) {
  std::vector<double> out;
  for (size_t at = 0; at <= cell.size();) {
    const size_t end = std::min(cell.find(", ", at), cell.size());
    out.push_back(markup::number(std::string_view(cell).substr(at, end - at)));
    at = end + 2;
  }
  return out;
}

/// Points every 0.1 m, 50 a row, with these distances; a NaN is a hidden point.
inline Comparison comparison_of(const std::vector<double>& distances) {
  Comparison out;
  Buffer<double> xyz(3 * distances.size());
  std::vector<uint8_t> status(distances.size());
  for (size_t i = 0; i < distances.size(); ++i) {
    xyz[3 * i] = 0.1 * static_cast<double>(i % 50);
    xyz[3 * i + 1] = 0.1 * static_cast<double>(i / 50);
    xyz[3 * i + 2] = 0;
    status[i] = static_cast<uint8_t>(std::isfinite(distances[i]) ? CompareStatus::kCompared
                                                                 : CompareStatus::kHidden);
  }
  out.cloud = std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
  add_column<double>(out.points, distances, "distance", "m", "", [](double d) { return d; });
  add_column<uint8_t>(out.points, status, "status", "", "", [](uint8_t s) { return s; });
  Task task;
  out.summary = summarise(distances, status, task);
  return out;
}

}  // namespace page_scenes
