// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec.h"
#include "segment/codes/code_table.h"

namespace jalon {

/// Something about the codes that a person should look at.
struct CodeWarning {
  size_t line = 0;  ///< of the list, from 1; 0: of no line
  std::string object, text;
};

/// A point of the list with one of its codes.
struct CodedPoint {
  std::string id;
  Vec3 position;  ///< m
  size_t line = 0;
  int64_t sequence = 0, modifier = kNoModifier;
};

struct CodeList {
  std::vector<CodedPoint>
      points;  ///< in the list's order; a point of several codes occurs as often
  std::vector<CodeWarning> warnings;
};

/// Reads lines "ID;X;Y;Z;code" (or with tabs), where a code is "sequence" or "sequence.modifier" and several codes of a
/// point stand with the table's separator between them. Blank lines and those that begin with # are passed over, a
/// first line without numbers is a heading. Codes that the table lacks, or that are no numbers, are warnings, and so is
/// an id that comes again, unless at the same place with another code; unit_m: metres in a unit of the coordinates.
/// Error(kFormat) names the line whose coordinates are no numbers.
CodeList read_code_list(std::string_view text, const CodeTable& table, double unit_m = 1);

}  // namespace jalon
