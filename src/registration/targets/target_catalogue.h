// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "registration/targets/measure.h"

namespace jalon {

/// A kind of target that was put up, and what it stands for.
struct CatalogueEntry {
  std::string code, name;
  TargetKind kind = TargetKind::kChecker;  ///< kChecker or kDisc
  double size_m = 0;                       ///< edge of a checker, diameter of a disc
};

/// Which targets were put up: kind and size of each, and its code.
struct TargetCatalogue {
  double size_sigma_m = 0.001;  ///< of printing: a target's size about the one stated
  std::vector<CatalogueEntry> entries;
};

/// Reads a catalogue; Error(kFormat) says what is wrong with it, Error(kInvalidArgument) that it is
/// no JSON. After: one entry or more.
TargetCatalogue target_catalogue_from_json(std::string_view text);

}  // namespace jalon
