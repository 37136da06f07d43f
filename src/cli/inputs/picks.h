// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/options.h"

namespace jalon::cli {

/// Segments picked by hand: "--pick [plane:|sphere:|cylinder:]X,Y,Z[;X,Y,Z ...]", a segment each, and "--pick-set".
struct Picks {
  std::vector<std::string> texts;
  Settings settings;  ///< of operation "pick"

  void add_to(Command& command);
  bool are_given() const { return !texts.empty(); }
  /// Refuses what no segment can be picked with, before a long read.
  void check() const;
  /// The cloud's segments, in the order of the picks; what a pick finds nothing at is told with it.
  Segmentation grown(const Console& console, const Cloud& cloud) const;
};

}  // namespace jalon::cli
