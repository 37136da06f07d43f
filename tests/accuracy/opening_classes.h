// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Openings that the chain found, with what they are in truth.
#pragma once

#include <string>
#include <vector>

#include "facade_truth.h"
#include "modelling/facade/opening_classes.h"

namespace jalon::test {

/// An opening found, what tells its class, and what it may be.
struct KnownOpening {
  std::string place;               ///< the facade it is of
  std::vector<OpeningKind> truth;  ///< one, or those that a coarser label does not tell apart
  OpeningKind kind = OpeningKind::kOpening;
  double confidence = kNaN;
  OpeningFeatures features{};

  bool is_certain() const { return kind != OpeningKind::kOpening; }
  bool is_right() const { return std::find(truth.begin(), truth.end(), kind) != truth.end(); }
};

/// The openings of a plan that lie over true ones; those where nothing is are kOpening, those that overlap something
/// badly are left out.
std::vector<KnownOpening> known_openings(const FacadePlan& plan, const FacadeTruth& truth,
                                         const std::string& place);

/// Those over labelled openings, "door ..." or "window ..."; a door may be a gateway or a shop front.
std::vector<KnownOpening> labelled_openings(const FacadePlan& plan,
                                            const std::vector<Drawn>& labels, const WallAxes& axes,
                                            const std::string& place);

/// Of those with a class.
double share_right(const std::vector<KnownOpening>& openings);

/// Confidence against the share that is right, in tenths; Brier score (1950) of the likeliest class being right.
std::string reliability_of(const std::vector<KnownOpening>& openings);
/// What is taken for what.
std::string confusion_of(const std::vector<KnownOpening>& openings);
double brier_score(const std::vector<KnownOpening>& openings);

}  // namespace jalon::test
