// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/handles.h"

namespace jalon::cli {

/// Targets as a file tells them; the rows point to the names.
struct Targets {
  std::vector<std::string> names;  ///< "" for none
  std::vector<jalon_target> rows;

  Targets() = default;
  Targets(Targets&&) = default;
  Targets& operator=(Targets&&) = default;
};

/// A line each: name x y z [sigma | sx sy sz], in metres, or x y z without a name ("-" is none too). Blanks, commas or
/// semicolons between; a heading, empty lines and lines from # on are left out. What is wrong is told with its line.
Targets read_targets(const std::string& path);

}  // namespace jalon::cli
