// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/evaluation/confusion.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/random.h"

using namespace jalon;

namespace {

template <class T>
Cloud labelled(const std::vector<int64_t>& predicted, const std::vector<T>& reference) {
  Cloud cloud = make_cloud(Buffer<double>(3 * predicted.size()));
  cloud.fields.set(make_column<int64_t>({"predicted"}, predicted));
  cloud.fields.set(make_column<T>({"reference"}, reference));
  return cloud;
}

Confusion confusion(const Cloud& cloud, std::vector<double> ignored = {}, unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  ConfusionSettings settings;
  settings.ignored_classes = std::move(ignored);
  return confusion_of(cloud, "predicted", "reference", settings, task);
}

double value(const FieldTable& table, const char* name, size_t row = 0) {
  return table.require(name).number(row);
}

}  // namespace

TEST_CASE("confusion__rates_of_a_case_done_by_hand") {
  // The last point's reference is ignored, and with it a class that nobody else has.
  const Confusion c = confusion(labelled<int64_t>({1, 1, 2, 2, 3, 0}, {1, 2, 2, 2, 1, 5}), {5});
  REQUIRE(c.classes == std::vector<int64_t>{1, 2, 3});
  CHECK(c.counts == std::vector<uint64_t>{1, 0, 1, 1, 2, 0, 0, 0, 0});
  CHECK(c.points == 5);
  const FieldTable t = class_table(c);
  const double precision[] = {0.5, 1, 0}, f1[] = {0.5, 0.8, 0}, iou[] = {1.0 / 3, 2.0 / 3, 0};
  for (size_t i = 0; i < 3; ++i) {
    CHECK(value(t, "precision", i) == doctest::Approx(precision[i]));
    CHECK(value(t, "f1", i) == doctest::Approx(f1[i]));
    CHECK(value(t, "iou", i) == doctest::Approx(iou[i]));
  }
  CHECK(value(t, "recall", 1) == doctest::Approx(2.0 / 3));
  CHECK(std::isnan(value(t, "recall", 2)));  // the reference has no point of class 3
  const FieldTable all = agreement_table(c);
  CHECK(value(all, "accuracy") == doctest::Approx(0.6));
  CHECK(value(all, "mean_precision") == doctest::Approx(0.75));  // of the reference's classes
  CHECK(value(all, "mean_f1") == doctest::Approx(0.65));
  CHECK(value(all, "kappa") == doctest::Approx((0.6 - 0.4) / (1 - 0.4)));
}

TEST_CASE("confusion__points_without_a_class_are_left_out_and_nothing_gives_NaN") {
  const Confusion c = confusion(labelled<double>({1, -7, 2}, {kNaN, -7, kNaN}));
  CHECK(c.classes == std::vector<int64_t>{-7});
  CHECK(c.points == 1);
  const Confusion none = confusion(labelled<int64_t>({}, {}));
  CHECK(none.size() == 0);
  CHECK(value(agreement_table(none), "points") == 0);
  CHECK(std::isnan(value(agreement_table(none), "accuracy")));
}

TEST_CASE("confusion__instances_instead_of_classes_are_refused") {
  std::vector<int64_t> many(1025);
  for (size_t i = 0; i < many.size(); ++i) many[i] = static_cast<int64_t>(i);
  try {
    confusion(labelled<int64_t>(many, many));
    FAIL("1025 classes were taken");
  } catch (const Error& error) {
    CHECK(error.status() == Status::kLimit);
  }
  many.pop_back();
  CHECK(confusion(labelled<int64_t>(many, many)).size() == 1024);
}

TEST_CASE("confusion__agrees_with_counting_one_by_one_for_any_number_of_threads") {
  RandomStream random(1, 1);
  std::vector<int64_t> a, b;
  std::vector<uint64_t> counts(25, 0);
  for (int i = 0; i < 100000; ++i) {
    b.push_back(static_cast<int64_t>(random.below(5)));
    a.push_back(random.uniform() < 0.7 ? b.back() : static_cast<int64_t>(random.below(5)));
    ++counts[static_cast<size_t>(5 * b.back() + a.back())];
  }
  const Cloud cloud = labelled<int64_t>(a, b);
  for (const unsigned threads : {1u, 3u}) CHECK(confusion(cloud, {}, threads).counts == counts);
}
