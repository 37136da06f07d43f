// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Packed points against the points: places to half a step, values to half of theirs, all of a small cloud.
#include "report/viewer/packing.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>

#include "base/random.h"
#include "unit/report/viewer/viewed.h"

using namespace jalon;
using viewed::random_cloud;

namespace {

viewed::Reader reader_of(const PackedCloud& packed) {
  const Inflated inflated(packed.bytes);
  REQUIRE(inflated.ok);
  return {inflated.text, packed.points};
}

/// Values by point index, found again by the order in which the tree has the points.
ViewChannel channel_of(ViewChannel::Kind kind, std::function<double(size_t)> value) {
  ViewChannel channel;
  channel.kind = kind;
  channel.low = -0.01;
  channel.high = 0.01;
  channel.none = {{{}, "none"}, {{}, "hidden"}};
  channel.value = std::move(value);
  return channel;
}

}  // namespace

TEST_CASE("viewer_packing__places_and_channels_come_back_within_half_a_step") {
  constexpr size_t kPoints = 5000;
  Task task;
  ViewCloud view;
  view.cloud = random_cloud(kPoints, 3, {652000, 6861000, 100}, 40);
  view.channels.push_back(
      channel_of(ViewChannel::Kind::kLabel, [](size_t i) { return i % 70000; }));
  view.channels.push_back(channel_of(ViewChannel::Kind::kScale, [](size_t i) {
    if (i % 50 == 0) return std::nan("");
    if (i % 50 == 1) return -std::numeric_limits<double>::infinity();
    return i % 50 == 2 ? 5.0 : 1e-6 * static_cast<double>(i) - 0.004;
  }));
  view.channels.push_back(
      channel_of(ViewChannel::Kind::kColour, [](size_t i) { return i * 3571 % 0xffffff; }));
  const PackedCloud packed = pack_cloud(view, 1000000, task);
  REQUIRE(packed.points == kPoints);
  CHECK(packed.step_m == 0.001);
  const auto order = view.cloud->octree(task)->order();
  viewed::Reader reader = reader_of(packed);
  std::vector<std::vector<uint32_t>> place;
  for (int k = 0; k < 3; ++k) place.push_back(reader.numbers(2));
  const auto labels = reader.numbers(2), values = reader.numbers(2, packed.channel_is_plain[1]),
             red = reader.numbers(1), green = reader.numbers(1), blue = reader.numbers(1);
  CHECK(reader.at == reader.bytes.size());
  for (size_t i = 0; i < kPoints; ++i) {
    const size_t point = order[i];
    for (int k = 0; k < 3; ++k)
      REQUIRE(std::fabs(place[static_cast<size_t>(k)][i] * packed.step_m + packed.low[k] -
                        view.cloud->point(point)[k]) <= 0.000501);
    REQUIRE(labels[i] == std::min<size_t>(point % 70000, 65535));
    REQUIRE((red[i] << 16 | green[i] << 8 | blue[i]) == point * 3571 % 0xffffff);
    const auto code = static_cast<int16_t>(values[i]);
    const double value = view.channels[1].value(point);
    if (std::isnan(value)) REQUIRE(code == -32768);
    else if (value < -1) REQUIRE(code == -32767);
    else if (value > 1) REQUIRE(code == 32765);
    else
      REQUIRE(std::fabs(code * packed.channel_steps[1] - value) <= 0.501 * packed.channel_steps[1]);
  }
}

TEST_CASE("viewer_packing__fewer_points_are_taken_evenly_each_once_and_the_same_each_time") {
  Task task;
  ViewCloud view;
  view.cloud = random_cloud(30000, 5, {0, 0, 0}, 10);
  const PackedCloud packed = pack_cloud(view, 1000, task), again = pack_cloud(view, 1000, task);
  CHECK(packed.points == 1000);
  CHECK(packed.bytes == again.bytes);
  viewed::Reader reader = reader_of(packed);
  const auto x = reader.numbers(2), y = reader.numbers(2), z = reader.numbers(2);
  std::set<std::tuple<uint32_t, uint32_t, uint32_t>> places;
  size_t octants[8] = {};
  for (size_t i = 0; i < 1000; ++i) {
    places.emplace(x[i], y[i], z[i]);
    ++octants[(x[i] > 5000) + 2 * (y[i] > 5000) + 4 * (z[i] > 5000)];
  }
  CHECK(places.size() == 1000);
  for (const size_t n : octants) CHECK(std::abs(static_cast<int>(n) - 125) < 25);
  CHECK(packed.spacing_m > 0.1);  // 1 000 points in 1 000 cubic metres: some decimetres
  CHECK(packed.spacing_m < 2);
}

TEST_CASE("viewer_packing__noise_is_told_as_it_is_and_what_runs_smoothly_as_differences") {
  Task task;
  ViewCloud view;
  view.cloud = random_cloud(3000, 4, {0, 0, 0}, 5);
  const Cloud& cloud = *view.cloud;
  view.channels.push_back(channel_of(ViewChannel::Kind::kScale,
                                     [](size_t i) { return RandomStream(i, 1).normal() * 0.002; }));
  view.channels.push_back(channel_of(ViewChannel::Kind::kScale,
                                     [&](size_t i) { return 0.001 * (cloud.point(i).x + 4); }));
  const PackedCloud packed = pack_cloud(view, 1000000, task);
  CHECK(packed.channel_is_plain[0]);
  CHECK_FALSE(packed.channel_is_plain[1]);
}

TEST_CASE("viewer_packing__bytes_as_text_are_five_characters_for_four") {
  CHECK(text_of_bytes("").empty());
  CHECK(text_of_bytes(std::string(4, '\0')) == "$$$$$");
  // 0xffffffff is 82 23 54 12 0 in base 85.
  CHECK(text_of_bytes(std::string(4, '\xff')) == "w;[0$");
  CHECK(text_of_bytes("abc").size() == 5);
  std::string all;
  for (int i = 0; i < 1024; ++i) all += static_cast<char>(i * 37 % 256);
  CHECK(text_of_bytes(all).find('<') == std::string::npos);
}

TEST_CASE("viewer_packing__a_large_cloud_has_wider_steps_and_an_empty_one_nothing") {
  Task task;
  ViewCloud view;
  view.cloud = random_cloud(2000, 6, {0, 0, 0}, 655350);
  CHECK(pack_cloud(view, 10000, task).step_m == doctest::Approx(10).epsilon(0.01));
  view.cloud = std::make_shared<const Cloud>();
  CHECK(pack_cloud(view, 10, task).points == 0);
}
