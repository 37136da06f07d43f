// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

#include "base/text_number.h"
#include "registration/coarse/coarse.h"
#include "unit/registration/coarse_scenes.h"
#include "unit/registration/real_scans.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("coarse__finds_real_scans_from_any_start") {
  const RealScans scans;
  if (!scans.exist()) return;
  const Cloud source = scans.source();
  const auto target = std::make_shared<const Cloud>(scans.target());
  const Transform truth = scans.pose();
  const uint64_t draws = std::getenv("JALON_FULL") ? 20 : 1;
  double most_m = 0, most_rad = 0, least_margin = 1;
  for (uint64_t draw = 0; draw < draws; ++draw)
    for (const bool any_axis : {false, true}) {
      const Transform start = random_start(draw, any_axis);
      Task task;
      const auto moving = std::make_shared<const Cloud>(transformed(source, start, task));
      const Registration r = register_coarse(target, moving, {}, CoarseSettings{}, task);
      const Transform off = r.pose * start * inverse(truth);
      const auto value = [&](const char* name) {
        return r.summary.require(name).values<double>()[0];
      };
      CHECK(r.converged);
      most_m = std::max(most_m, norm(off.point({}))),
      most_rad = std::max(most_rad, norm(rotation_vector(off)));
      least_margin = std::min(least_margin, 1 - value("second_score") / value("score"));
    }
  MESSAGE("FIGURE coarse on real scans, "
          << 2 * draws << " starts: within " << most_m << " m and " << most_rad * 57.29578
          << " degrees; margin over the second pose at least " << least_margin);
  CHECK(most_m < 0.1);
  CHECK(most_rad < 0.01);
  CHECK(least_margin > 0.2);
}

TEST_CASE("coarse__does_not_lay_one_facade_on_another") {
  if (!RealScans().exist()) return;
  const auto read_facade = [](const char* name) {
    std::ifstream file(std::string(JALON_SHARED_DATA) + "/facades/" + name);
    std::vector<Vec3> points;
    std::string line;
    while (std::getline(file, line)) {
      if (line.empty() || line[0] == '#') continue;
      Vec3 p;
      size_t from = 0;
      for (int k = 0; k < 3; ++k) {
        const size_t to = std::min(line.find_first_of(" \r", from), line.size());
        if (!parse_number(std::string_view(line).substr(from, to - from), p[k])) break;
        from = to + 1;
      }
      points.push_back(p);
    }
    return points;
  };
  const auto shared = [](const std::vector<Vec3>& points) {
    return std::make_shared<const Cloud>(cloud_of(points));
  };
  const std::vector<Vec3> first = read_facade("street_1.txt"), other = read_facade("street_3.txt");
  const auto run = [&](const std::vector<Vec3>& reference, const std::vector<Vec3>& moving) {
    Task task;
    return register_coarse(shared(reference), shared(moving), {}, CoarseSettings{}, task);
  };
  const Registration wrong = run(first, other);
  MESSAGE("FIGURE coarse on two facades: stopped " << static_cast<int>(wrong.stopped));
  CHECK_FALSE(wrong.converged);
  // Two thirds of one, in different points: every other one.
  std::vector<Vec3> left, right;
  const Transform start = random_start(3);
  double low = 1e9, high = -1e9;
  for (const Vec3& p : first) low = std::min(low, p.y), high = std::max(high, p.y);
  for (size_t i = 0; i < first.size(); ++i) {
    const double at = (first[i].y - low) / (high - low);
    if (i % 2 == 0 && at < 0.67) left.push_back(first[i]);
    if (i % 2 == 1 && at > 0.33) right.push_back(start.point(first[i]));
  }
  const Registration halves = run(left, right);
  const Vec3 place = left[left.size() / 2];
  const double off = norm(halves.pose.point(start.point(place)) - place);
  MESSAGE("FIGURE coarse on parts of a facade: off " << off << " m, stopped "
                                                     << static_cast<int>(halves.stopped));
  CHECK(halves.converged);
  CHECK(off < 0.1);
}
