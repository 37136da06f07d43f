// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/opening_classes.h"

#include <algorithm>
#include <cmath>

#include "model/part_classes.h"
#include "modelling/facade/class_weights.h"

namespace jalon {

namespace {

void set_kind(const OpeningFeatures& features, const ClassSetting& setting,
              FacadeOpening& opening) {
  const auto probabilities = class_probabilities(features);
  const auto likeliest = std::max_element(probabilities.begin(), probabilities.end());
  opening.kind_confidence = *likeliest;
  opening.kind = *likeliest >= setting.min_confidence
                     ? static_cast<OpeningKind>(likeliest - probabilities.begin())
                     : OpeningKind::kOpening;
}

}  // namespace

const char* class_of(OpeningKind kind) {
  switch (kind) {
    case OpeningKind::kWindow:
      return part_class::kWindow;
    case OpeningKind::kDoor:
      return part_class::kDoor;
    case OpeningKind::kGateway:
      return part_class::kGateway;
    case OpeningKind::kShopFront:
      return part_class::kShopFront;
    case OpeningKind::kVent:
      return part_class::kVent;
    case OpeningKind::kRecess:
      return part_class::kRecess;
    case OpeningKind::kOpening:
      break;
  }
  return part_class::kOpening;
}

std::array<double, kOpeningKinds> class_probabilities(const OpeningFeatures& features) {
  std::array<double, kOpeningKinds> out{};
  for (size_t k = 0; k < kOpeningKinds; ++k)
    for (size_t i = 0; i < kOpeningFeatures; ++i) out[k] += kClassWeights[k][i] * features[i];
  // The greatest score first, so that no exponential overflows.
  const double most = *std::max_element(out.begin(), out.end());
  double sum = 0;
  for (double& score : out) sum += score = std::exp(score - most);
  for (double& p : out) p /= sum;
  return out;
}

void classify_openings(const ClassSetting& setting, FacadePlan& plan) {
  for (PlannedFacade& facade : plan.facades) {
    const auto features = opening_features(plan, facade);
    for (size_t w = 0; w < facade.walls.size(); ++w) {
      std::vector<FacadeOpening>& openings = facade.walls[w].wall.openings;
      for (size_t o = 0; o < openings.size(); ++o) set_kind(features[w][o], setting, openings[o]);
      for (FacadeOpening& copy : openings) {
        if (copy.copied_from < 0) continue;
        const FacadeOpening& source = openings[static_cast<size_t>(copy.copied_from)];
        copy.kind = source.kind;
        copy.kind_confidence = source.kind_confidence;
      }
    }
  }
}

}  // namespace jalon
