// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_confidence.h"

#include <doctest/doctest.h>

#include "compare/changes/confidence_weights.h"

using namespace jalon;

namespace {

Change change_with(ChangeClass change_class, const ChangeFeatures& features) {
  Change out;
  out.change_class = change_class;
  out.features = features;
  return out;
}

}  // namespace

TEST_CASE("confidence_of__is_the_logistic_of_the_weighted_features_of_its_family") {
  ChangeFeatures features{};
  features[kFeatureOne] = 1;
  features[kFeatureLevels] = 2;
  for (const ChangeClass c :
       {ChangeClass::kAppearance, ChangeClass::kDisplacement, ChangeClass::kDeformationOverlap}) {
    const Change change = change_with(c, features);
    const auto& weights = kConfidenceWeights[family_of(change)];
    const double score = weights[kFeatureOne] + 2 * weights[kFeatureLevels];
    CHECK(confidence_of(change) == doctest::Approx(1 / (1 + std::exp(-score))));
  }
}

TEST_CASE("confidence_of__grows_with_the_changed_points_and_falls_by_hidden_ones_beside") {
  ChangeFeatures features{};
  features[kFeatureOne] = 1;
  features[kFeatureThrough] = 1;
  features[kFeaturePoints] = 1;
  const double few = confidence_of(change_with(ChangeClass::kAppearance, features));
  features[kFeaturePoints] = 4;
  const double many = confidence_of(change_with(ChangeClass::kAppearance, features));
  CHECK(many > few);
  features[kFeatureBesideHidden] = 0.3;
  CHECK(confidence_of(change_with(ChangeClass::kAppearance, features)) < many);
}

TEST_CASE("is_told__by_a_half") {
  Change change;
  change.confidence = 0.5;
  CHECK(is_told(change));
  change.confidence = 0.49;
  CHECK_FALSE(is_told(change));
}
