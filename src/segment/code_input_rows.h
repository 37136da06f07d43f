// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/setting_rows.h"
#include "segment/codes_settings.h"

namespace jalon {

/// The rows that both methods by codes have.
constexpr auto code_input_rows(const char* method) {
  return setting_rows(
      string_row<&CodeInput::codes>(
          "codes", method,
          "The coded points as text, a line each: ID;X;Y;Z;code, where a code is sequence or "
          "sequence.modifier. Without any the segmentation is empty."),
      choice_row<&CodeInput::codes_unit>(
          "codes_unit", "m|cm|mm|ft|us-ft", method,
          "Unit of X, Y and Z of the codes; clouds are in metres, also those of files in feet."),
      string_row<&CodeInput::table>(
          "table", method,
          "Code table as JSON: names, numbers, geometry and classes of the codes; empty = the "
          "method's own."),
      choice_row<&CodeInput::classes>(
          "classes", "table|asprs", method,
          "Numbers of the field \"classification\": those of the code table, or ASPRS: 1 rest, 6 "
          "walls, 64 doors, 65 windows, 66 gutters."),
      choice_row<&CodeInput::form>(
          "form", "source|improved", method,
          "source: the thesis' steps; improved: the fronts of frames and leaves and the places of "
          "gutters are found in the cloud, and reveals are their walls'."));
}

}  // namespace jalon
