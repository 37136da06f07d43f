// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/labels/label_groups.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>

#include "base/random.h"

using namespace jalon;

TEST_CASE("label_groups__every_point_in_the_group_of_its_label_in_order") {
  RandomStream random(3, 3);
  std::vector<uint32_t> labels(5000);
  for (uint32_t& label : labels) label = static_cast<uint32_t>(random.below(8));
  Task task;
  const LabelGroups groups(labels, 9, task);
  REQUIRE(groups.count() == 9);
  for (uint32_t label = 1; label <= 9; ++label) {
    std::vector<uint32_t> expected;
    for (uint32_t i = 0; i < labels.size(); ++i)
      if (labels[i] == label) expected.push_back(i);
    const auto found = groups.of(label);
    CHECK(std::vector<uint32_t>(found.begin(), found.end()) == expected);
  }
  CHECK(groups.of(8).empty());  // no point has it
}

TEST_CASE("label_groups__of_many_points_are_the_same_with_any_number_of_threads") {
  // Several blocks, whose size follows the number of labels where these are many.
  constexpr size_t kPoints = 1'100'000;
  for (const uint32_t count : {5u, 400'000u}) {
    RandomStream random(4, count);
    std::vector<uint32_t> labels(kPoints);
    for (uint32_t& label : labels) label = static_cast<uint32_t>(random.below(count + 1));
    for (const unsigned threads : {1u, 3u}) {
      Task::Hooks hooks;
      hooks.threads = threads;
      Task task(hooks);
      const LabelGroups groups(labels, count, task);
      size_t held = 0, wrong = 0;
      for (uint32_t label = 1; label <= count; ++label) {
        const auto points = groups.of(label);
        held += points.size();
        for (size_t k = 0; k < points.size(); ++k)
          if (labels[points[k]] != label || (k > 0 && points[k - 1] >= points[k])) ++wrong;
      }
      CHECK(wrong == 0);
      CHECK(held == kPoints - static_cast<size_t>(std::ranges::count(labels, 0u)));
    }
  }
}

TEST_CASE("label_groups__of_nothing") {
  Task task;
  CHECK(LabelGroups({}, 0, task).count() == 0);
  const std::vector<uint32_t> noise(10, 0);
  const LabelGroups groups(noise, 2, task);
  CHECK(groups.of(1).empty());
  CHECK(groups.of(2).empty());
}

TEST_CASE("label_groups__for_each_comes_to_large_and_small_groups_once") {
  // 70 000 points are a large group; 40 small ones fill more than one chunk.
  std::vector<uint32_t> labels(70000, 17);
  for (uint32_t i = 0; i < 4000; ++i) labels.push_back(1 + i % 40);
  Task::Hooks hooks;
  hooks.threads = 3;
  Task task(hooks);
  const LabelGroups groups(labels, 41, task);
  std::vector<std::atomic<int>> visits(42);
  groups.for_each(task, [&](uint32_t label) { ++visits[label]; });
  CHECK(visits[0] == 0);
  for (size_t label = 1; label <= 41; ++label) CHECK(visits[label] == 1);
}
