// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the diagnosis says of two epochs whose truth is known, and how often it is right.

#include <map>
#include <string>
#include <vector>

#include "change_kinds.h"

namespace jalon::test {

/// Both scans; of each point the thing that it lies on.
struct KnownEpochs {
  CloudPtr before, after;
  std::vector<uint32_t> objects_before, objects_after;
  std::vector<TrueChange> changes;
  /// Of the changes: what both epochs saw enough of.
  std::vector<uint8_t> can_be_told;
};

struct Statement {
  uint32_t object = 0;
  ChangeClass change_class = ChangeClass::kAppearance;
  double confidence = 0;
  bool is_changed = false;    ///< the thing did change
  bool is_right = false;      ///< and in this way
  bool is_one_thing = false;  ///< right, and where it moved, it is the same thing on both sides
  ChangeFeatures features{};
};

/// One diagnosis.
struct ScoredRun {
  std::string kind;
  uint64_t seed = 0;
  double threshold_m = 0;
  bool has_stations = false;
  size_t planted = 0;          ///< that can be told and exceed twice the threshold
  size_t found = 0;            ///< of those, with the right class
  size_t changes_of_kind = 0;  ///< whether told or not; 0: an unchanged scene
  std::vector<Statement> statements, untold, weighed;
  std::map<std::string, size_t> confusion;  ///< "truth > said"
};

KnownEpochs known_epochs(const EpochScenes& scenes, uint64_t seed);
/// The scene "street" in two epochs, or the first one twice, as files without stations hold them.
KnownEpochs known_street(uint64_t seed, bool is_unchanged);

/// {2, 5 cm} x {stations known, unknown}.
std::vector<ScoredRun> scored_runs(const std::string& kind, const KnownEpochs& epochs,
                                   uint64_t seed);

/// Of all statements of some runs.
struct ConfidenceFigures {
  size_t statements = 0, about_changed = 0, right_class = 0, sure = 0, sure_right = 0;
  size_t planted = 0, found = 0, unchanged = 0, unchanged_clean = 0;
  double expected_error = 0;  ///< of the confidence, in ten bins of equal count
  std::string bins;           ///< "0.63:0.60 ...", said and true

  double class_right() const { return ratio(right_class, about_changed); }
  double found_right() const { return ratio(found, planted); }
  double sure_share() const { return ratio(sure_right, sure); }
  double clean() const { return ratio(unchanged_clean, unchanged); }
  static double ratio(size_t a, size_t b) {
    return b > 0 ? static_cast<double>(a) / static_cast<double>(b) : 1;
  }
};
ConfidenceFigures figures_of(const std::vector<ScoredRun>& runs);
std::string text_of(const ConfidenceFigures& figures);
/// By kind: what was mistaken for what.
std::string confusion_of(const std::vector<ScoredRun>& runs);

}  // namespace jalon::test
