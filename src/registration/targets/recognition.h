// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/targets/measure.h"
#include "registration/targets/target_catalogue.h"

namespace jalon {

/// What a found target is; the numbers of jalon/targets.h.
enum class TargetVerdict : uint8_t {
  kKnown = 1,      ///< one entry of the catalogue fits, with the confidence asked for
  kAmbiguous = 2,  ///< two entries, or two readings of the pattern, fit
  kForeign = 3,    ///< a target that is in no entry
  kUncertain = 4,  ///< it may be no target
};

/// A target found by its pattern.
struct RecognisedTarget {
  Vec3 place;               ///< what the centre is relative to
  MeasuredTarget measured;  ///< at its own size
  double size_m = 0, size_sigma_m = 0;
  double misfit = 1, contrast_to_noise = 0;
  double pattern_confidence = 0;  ///< that it is a target of this kind at all
  TargetVerdict verdict = TargetVerdict::kUncertain;
  int32_t entry = -1, second = -1;  ///< of the catalogue, by how well they fit; -1: none
  double confidence = 0;            ///< of the entry, or, without one, of the pattern

  Vec3 centre() const { return place + measured.centre; }
};

/// Which entries of the catalogue this kind and size fit, and how sure that is: the chances of all
/// entries of the kind, and of a target of any other size, by Bayes' rule.
void judge(const TargetCatalogue& catalogue, double least_confidence, RecognisedTarget& target);

/// Flat targets of the whole cloud by their brightness.
/// 1. Places where it may show a pattern of a size of the catalogue (pattern_places.h).
/// 2. Each measured as a flat target there, then once more at its own size.
/// 3. The border of the pattern, and what of its brightness it leaves unexplained.
/// 4. Of readings at one place the best; entries of the catalogue that fit.
///
/// After: facade by facade, along x, then y, then z. Error(kNotFound) for a cloud without the field,
/// Error(kInsufficientData) for one that is the same everywhere.
std::vector<RecognisedTarget> recognised_targets(const Cloud& cloud,
                                                 const TargetCatalogue& catalogue,
                                                 const MeasuringSettings& settings, Task& task);
/// A row a target: see jalon/targets.h.
FieldTable recognise_targets(const Cloud& cloud, const MeasuringSettings& settings, Task& task);

}  // namespace jalon
