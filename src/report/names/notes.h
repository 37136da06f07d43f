// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace jalon {

/// What the caller adds to a report.
struct Notes {
  std::string title = "Facade report";
  std::vector<std::pair<std::string, std::string>> input;  ///< in the order given
  std::string scanner_json;  ///< parameters of operation "precision"; empty: not told
  std::vector<std::pair<std::string, double>> times_s;
};

/// Reads {"title": text, "input": {name: text, ...}, "scanner": {parameter of operation "precision": value, ...},
/// "times": {stage: seconds, ...}}; "" gives the defaults, other members are ignored. A text that is no such object is
/// Error(kInvalidArgument). Numbers and booleans in "input" are taken as text.
Notes read_notes(std::string_view json);

}  // namespace jalon
