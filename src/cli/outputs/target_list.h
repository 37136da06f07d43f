// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/console.h"
#include "cli/table.h"

namespace jalon::cli {

inline constexpr int kPlaceDecimals = 4;  // tenths of a millimetre
inline constexpr double kTargetMm_per_m = 1e3;

inline const char* verdict_name(uint64_t verdict) {
  switch (verdict) {
    case JALON_RECOGNISED_KNOWN:
      return "known";
    case JALON_RECOGNISED_AMBIGUOUS:
      return "ambiguous";
    case JALON_RECOGNISED_FOREIGN:
      return "foreign";
    default:
      return "uncertain";
  }
}

/// The catalogue as the library has read it: the entry of a row.
inline std::string entry_text(const nlohmann::ordered_json& catalogue, double entry,
                              const char* what) {
  if (entry < 0) return "";
  const nlohmann::ordered_json& row = catalogue["targets"][static_cast<size_t>(entry)];
  if (!row.contains(what)) return "";
  return row[what].is_string() ? row[what].get<std::string>() : row[what].dump();
}

/// Rows of targets.csv.
inline nlohmann::ordered_json target_rows_of(const Table& table,
                                             const nlohmann::ordered_json& catalogue) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (uint64_t i = 0; i < table.rows(); ++i) {
    const double entry = table.number("entry", i), second = table.number("second", i);
    const bool is_known = table.count("verdict", i) == JALON_RECOGNISED_KNOWN;
    nlohmann::ordered_json row{{"id", "T" + std::to_string(i + 1)}};
    for (uint32_t k = 0; k < 3; ++k) row[std::string(1, "xyz"[k])] = table.number("centre", i, k);
    for (uint32_t k = 0; k < 3; ++k)
      row[std::string("sigma_") + "xyz"[k] + "_m"] =
          std::sqrt(table.number("covariance", i, 4 * k));
    row["kind"] = table.count("kind", i) == JALON_TARGET_CHECKER ? "checker" : "disc";
    row["size_m"] = table.number("size", i);
    row["size_sigma_m"] = table.number("size_sigma", i);
    row["verdict"] = verdict_name(table.count("verdict", i));
    row["code"] = is_known ? entry_text(catalogue, entry, "code") : "";
    row["name"] = is_known ? entry_text(catalogue, entry, "name") : "";
    row["confidence"] = table.number("confidence", i);
    row["may_be"] = is_known ? "" : entry_text(catalogue, entry, "code");
    row["or"] = entry_text(catalogue, second, "code");
    row["target_confidence"] = table.number("pattern_confidence", i);
    row["points"] = table.count("points", i);
    out.push_back(std::move(row));
  }
  return out;
}

/// Those with a code as "jalon code --method targets" reads them.
inline std::string target_code_lines(const nlohmann::ordered_json& rows) {
  std::string out;
  for (const nlohmann::ordered_json& row : rows) {
    if (row["verdict"] != "known") continue;
    out += row["id"].get<std::string>();
    for (const char* axis : {"x", "y", "z"})
      out += ";" + fixed(row[axis].get<double>(), kPlaceDecimals);
    out += ";" + row["code"].get<std::string>() + "\n";
  }
  return out;
}

inline std::string target_line(const nlohmann::ordered_json& row) {
  const bool is_known = row["verdict"] == "known";
  const auto text = [&](const char* name) { return row[name].get<std::string>(); };
  const std::string maybe = is_known || text("may_be").empty() ? "" : ", perhaps " + text("may_be"),
                    other = text("or").empty() ? "" : " or " + text("or");
  return text("id") + ": " + text("kind") + " of " +
         fixed(row["size_m"].get<double>() * kTargetMm_per_m, 0) + " mm, " +
         (is_known ? "code " + text("code") : text("verdict")) + maybe + other + ", confidence " +
         fixed(row["confidence"].get<double>(), 2);
}

}  // namespace jalon::cli
