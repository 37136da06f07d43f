// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/facade/opening_features.h"

namespace jalon {

/// The words of OpeningKind, of part_classes.h.
const char* class_of(OpeningKind kind);

/// Probabilities of the kinds by multinomial logistic regression (Bishop 2006, 4.3.4); that of kOpening: of something
/// else than the others. Their sum is 1.
std::array<double, kOpeningKinds> class_probabilities(const OpeningFeatures& features);

/// Sets kind and kind_confidence of all openings; copies have those of what they repeat. kind: the likeliest where its
/// probability reaches the limit, else kOpening; kind_confidence: that of the likeliest.
void classify_openings(const ClassSetting& setting, FacadePlan& plan);

}  // namespace jalon
