// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "cli/options.h"

namespace jalon::cli {

/// How lengths are shown to people: in metres and millimetres where the input tells its unit, by its CRS or by --unit;
/// in "units" where it does not. Parameters take those for metres.
class Lengths {
 public:
  Lengths() = default;
  static Lengths of(const Input& input, const Cloud& cloud);
  static Lengths of(const std::string& path, const Model& model);
  /// Of a result of both: known where both are.
  Lengths with(const Lengths& other) const;

  bool is_known() const { return files_.empty(); }
  const char* length() const { return is_known() ? "m" : "units"; }
  const char* fine() const { return is_known() ? "mm" : "units"; }
  /// A small length: in millimetres with so many decimals, or in units with three more.
  std::string fine(double length_m, int decimals_mm) const;
  /// "  area m2" in a column of this width; without the unit, which note() tells, where it is unknown.
  std::string heading(const std::string& name, const char* unit, size_t width) const;
  /// The line that says what "units" are, "" where the unit is known.
  std::string note() const;
  /// The same for the list of a report's input.
  std::string in_report() const;

 private:
  std::string files_;    ///< those that tell nothing; "" = the unit is known
  std::string options_;  ///< that tell it
};

/// Ends a command that found nothing in a scan, before anything is written: says what, where, and which options matter.
[[noreturn]] void found_nothing(const Input& input, const Cloud& cloud, const std::string& what,
                                const std::string& options);

/// Warns where one of two things that should lie on each other is a power of ten as large as the other, as is one in
/// millimetres beside one in metres.
void warn_of_sizes(const Console& console, const std::string& reference, const jalon_box& a,
                   const std::string& other, const jalon_box& b);
/// The box of a cloud, and of a model by its vertices; no point, no extent.
jalon_box box_of(const Cloud& cloud);
jalon_box box_of(const Model& model);

}  // namespace jalon::cli
