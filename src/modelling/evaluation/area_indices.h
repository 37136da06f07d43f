// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "base/field.h"
#include "base/numbers.h"
#include "base/params.h"

namespace jalon {

/// Which definitions the indices follow (Boulaassal 2010, 5.6.3.2, table 5.5).
enum class IndexFormulas : uint8_t {
  kCanonical,  ///< of the literature: branching FP/TP, miss FN/TP, failure FP/|SR| (the false alarm rate)
  kThesis,  ///< as printed in Boulaassal 2010: rho_b = |SR \ SA| / TP, rho_m = |SA \ SR| / TP: the two swapped
};
struct IndexSettings {
  IndexFormulas formulas = IndexFormulas::kCanonical;
};

/// Areas of an automatic polygon SA, its reference SR and their intersection, in one plane.
struct ComparedAreas {
  double automatic_m2 = 0, reference_m2 = 0, intersection_m2 = 0;
  double excess_m2() const { return automatic_m2 - intersection_m2; }   ///< FP = |SA \ SR|
  double deficit_m2() const { return reference_m2 - intersection_m2; }  ///< FN = |SR \ SA|
  double union_m2() const { return automatic_m2 + reference_m2 - intersection_m2; }
  ComparedAreas& operator+=(const ComparedAreas& b);
};

/// Identities (canonical): quality = 1 / (1 + branching + miss); completeness = 1 / (1 + miss); correctness = 1 / (1 +
/// branching). branching and miss are inf where nothing is shared; a rate of nothing is NaN.
struct AreaIndices {
  double completeness = kNaN;  ///< rho_d: TP / |SR|, the detection rate
  double correctness = kNaN;   ///< TP / |SA|
  double quality = kNaN;       ///< rho_q: TP / |SR u SA|
  double branching = kNaN;     ///< rho_b, the excess factor
  double miss = kNaN;          ///< rho_m, the deficit factor
  double failure = kNaN;   ///< rho_f as printed, FP / |SR|; the words of the thesis mean omission
  double omission = kNaN;  ///< FN / |SR|
};
AreaIndices area_indices(const ComparedAreas& areas, IndexFormulas formulas);

struct MeanAndStd {
  double mean = kNaN, std = kNaN;  ///< divided by n - 1; of the finite values
};
MeanAndStd mean_and_std(std::span<const double> values);

/// Operation "indices": IndexSettings.
std::span<const ParamRow> indices_rows();
/// A row a triple with the indices; all arrays of one length. Error(kInvalidArgument) naming the first row that is
/// negative, not finite or whose intersection exceeds one of the two.
FieldTable index_table(std::span<const ComparedAreas> rows, IndexFormulas formulas);
/// One row: the sums of the areas, those of unpaired polygons added, and their indices ("total_..."); mean and standard
/// deviation of each index over the rows ("mean_...", "std_...").
FieldTable index_totals_table(std::span<const ComparedAreas> rows, const ComparedAreas& unpaired,
                              IndexFormulas formulas);
void require_areas(std::span<const ComparedAreas> rows);

}  // namespace jalon
