// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Blocks of points before a frame: the same numbers as point by point.
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "base/random.h"
#include "modelling/plane/point_block.h"

using namespace jalon;

namespace {

constexpr size_t kPoints = 3 * PointBlock::kMost + 17;

// On a national grid, 20 m wide.
Cloud cloud_of(uint64_t seed) {
  RandomStream random(seed, 0);
  Buffer<double> xyz(3 * kPoints);
  for (size_t i = 0; i < kPoints; ++i) {
    xyz[3 * i] = 652000 + 20 * random.uniform();
    xyz[3 * i + 1] = 6862000 + 20 * random.uniform();
    xyz[3 * i + 2] = 35 + 20 * random.uniform();
  }
  Cloud cloud;
  cloud.xyz_buffer = std::make_shared<Buffer<double>>(std::move(xyz));
  return cloud;
}

PlaneFrame turned_frame() {
  PlaneFrame frame;
  frame.origin = {652010, 6862010, 40};
  frame.axis_u = {0.8, 0.6, 0};
  frame.axis_v = {0, 0, 1};
  frame.normal = {0.6, -0.8, 0};
  frame.height = 0.25;
  return frame;
}

std::vector<uint32_t> backwards() {
  std::vector<uint32_t> order(kPoints);
  std::iota(order.rbegin(), order.rend(), 0u);
  return order;
}

}  // namespace

TEST_CASE("point_blocks__give_the_bits_of_the_frame_for_any_order_and_a_last_block_that_is_short") {
  const Cloud cloud = cloud_of(1);
  const PlaneFrame frame = turned_frame();
  const std::vector<uint32_t> order = backwards();
  PointBlock block;
  double w[PointBlock::kMost], u[PointBlock::kMost], v[PointBlock::kMost];
  for (const std::span<const uint32_t> some : {std::span<const uint32_t>{}, std::span{order}}) {
    size_t seen = 0;
    for (size_t first = 0; first < kPoints; first += PointBlock::kMost) {
      block.fill(cloud, some, first, std::min(PointBlock::kMost, kPoints - first));
      block.heights(frame, w);
      block.project(frame, u, v);
      for (size_t k = 0; k < block.count(); ++k, ++seen) {
        const Vec3 p = cloud.point(block.index(k));
        const Vec2 q = frame.project(p);
        REQUIRE(block.index(k) == (some.empty() ? first + k : order[first + k]));
        REQUIRE(u[k] == q.u);
        REQUIRE(v[k] == q.v);
        REQUIRE(w[k] == dot(p - frame.origin, frame.normal) - frame.height);
      }
    }
    CHECK(seen == kPoints);
  }
}

TEST_CASE("point_blocks__bounds_hold_every_point_and_little_more_than_their_box") {
  const Cloud cloud = cloud_of(2);
  const PlaneFrame frame = turned_frame();
  PointBlock block;
  double w[PointBlock::kMost], u[PointBlock::kMost], v[PointBlock::kMost];
  for (size_t first = 0; first < kPoints; first += PointBlock::kMost) {
    block.fill(cloud, {}, first, std::min(PointBlock::kMost, kPoints - first));
    block.heights(frame, w);
    block.project(frame, u, v);
    const FrameBox box = block.bounds(frame);
    for (size_t k = 0; k < block.count(); ++k) {
      REQUIRE((u[k] >= box.low.u && u[k] <= box.high.u));
      REQUIRE((v[k] >= box.low.v && v[k] <= box.high.v));
      REQUIRE((w[k] >= box.lowest && w[k] <= box.highest));
    }
    // A cube of 20 m whose horizontal sides are turned: 28 m across at most, 20 m high.
    CHECK(box.high.u - box.low.u <= 20 * 1.4 + 1e-3);
    CHECK(box.high.v - box.low.v <= 20 + 1e-3);
    CHECK(box.highest - box.lowest <= 20 * 1.4 + 1e-3);
  }
}
