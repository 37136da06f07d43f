// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace jalon::cli {

/// A cell of comma-separated text: in quotes where it needs them, and behind an apostrophe where a spreadsheet
/// would take
/// it for a formula.
std::string csv_cell(const std::string& text);
/// A list of objects of the same keys as comma-separated text with a heading; arrays as name_0, name_1 ..., null is
/// nothing.
std::string csv_of(const nlohmann::ordered_json& rows);

}  // namespace jalon::cli
