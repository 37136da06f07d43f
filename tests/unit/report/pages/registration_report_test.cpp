// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The page on a registration: distances before and after a motion that is known, and only the chapters that there are.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/random.h"
#include "report/pages/registration_report.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using page_scenes::has;
using page_scenes::number_after;

namespace {

constexpr double kShift_m = 0.1, kFloorNoise_m = 0.002;

// One point somewhere in the middle half of each cell: neighbours always span a plane.
CloudPtr floor_points(size_t n, double side_m, double height_m, double noise_m, uint64_t seed) {
  RandomStream random(seed, 5);
  Buffer<double> xyz(3 * n);
  const auto cells = static_cast<size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  const auto within = [&](size_t cell) {
    const double at = static_cast<double>(cell) + 0.25 + 0.5 * random.uniform();
    return side_m * (at / static_cast<double>(cells) - 0.5);
  };
  for (size_t i = 0; i < n; ++i) {
    xyz[3 * i] = within(i % cells);
    xyz[3 * i + 1] = within(i / cells);
    xyz[3 * i + 2] = height_m + noise_m * random.normal();
  }
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

// The moving floor lies 0.1 m below the reference; the pose lifts it.
Registration lifted() {
  Registration out;
  out.pose.m[11] = kShift_m;
  out.stopped = StopReason::kConverged;
  out.converged = true;
  return out;
}

std::string page_of(const Registration& r, const CloudPtr& reference, const CloudPtr& moving,
                    int64_t sample = 100000) {
  Task task;
  return registration_html(r, reference, moving, "", {.sample = sample}, task);
}

}  // namespace

TEST_CASE("registration_report__distances_go_from_the_shift_to_the_noise") {
  const CloudPtr reference = floor_points(8000, 4, 0, 0, 1),
                 moving = floor_points(1500, 3.5, -kShift_m, kFloorNoise_m, 2);
  const std::string html = page_of(lifted(), reference, moving);
  CHECK(markup::well_formed(html));
  const size_t after = html.find(">After<");
  REQUIRE(after != std::string::npos);
  // Four standard deviations of a median and of a root mean square of 1500 normal values, and the last digit.
  const double median_mm = 1000 * kFloorNoise_m * 4 * 1.2533 / std::sqrt(1500.0) + 0.01;
  CHECK(std::abs(number_after(html, "median ") - 1000 * kShift_m) < median_mm);
  CHECK(std::abs(number_after(html.substr(after), "rms ") - 1000 * kFloorNoise_m) <
        1000 * kFloorNoise_m * 4 / std::sqrt(3000.0) + 0.01);
  // Of a folded normal distribution 0.6745 sigma.
  CHECK(std::abs(number_after(html.substr(after), "median ") - 674.5 * kFloorNoise_m) < median_mm);
  CHECK(number_after(html.substr(after), "95 % below ") >
        number_after(html.substr(after), "median "));
}

TEST_CASE("registration_report__histograms_hold_no_more_points_than_asked_for") {
  const CloudPtr reference = floor_points(2000, 4, 0, 0, 3),
                 moving = floor_points(1501, 3, 0, 0, 4);
  for (const int64_t most : {1, 100, 1500, 1501, 5000}) {
    const double n = number_after(page_of(lifted(), reference, moving, most), "Distances of ");
    CAPTURE(most);
    CHECK(n <= static_cast<double>(most));
    CHECK(n <= 1501);
    // A stride of whole points leaves half of what is asked for at least.
    CHECK(n >= std::min(1501.0, static_cast<double>(most)) / 2);
  }
  CHECK(number_after(page_of(lifted(), reference, moving, 1501), "Distances of ") == 1501);
}

TEST_CASE("registration_report__tells_how_many_distances_are_from_points_and_not_planes") {
  Task task;
  const CloudPtr floor = floor_points(2000, 4, 0, 0, 7),
                 low = floor_points(500, 3, -kShift_m, 0, 8);
  CHECK(!has(page_of(lifted(), floor, low), "nearest point of the reference"));
  Buffer<double> beyond(9);  // a metre and more outside the floor, which ends at 2 m
  for (size_t i = 0; i < 3; ++i) {
    beyond[3 * i] = 4.0 + static_cast<double>(i);
    beyond[3 * i + 1] = 0;
    beyond[3 * i + 2] = -kShift_m;
  }
  const auto more =
      std::make_shared<const Cloud>(append(*low, make_cloud(std::move(beyond)), task));
  const std::string html = page_of(lifted(), floor, more);
  CHECK(number_after(html, "The figures have ") == 3);
  CHECK(has(html, "nearest point of the reference"));
}

TEST_CASE("registration_report__has_only_the_chapters_of_what_there_is") {
  const CloudPtr floor = floor_points(500, 2, 0, 0, 5), nothing = floor_points(0, 1, 0, 0, 6);
  Registration r = lifted();
  const std::vector<std::pair<CloudPtr, CloudPtr>> pairs{
      {nullptr, floor}, {floor, nullptr}, {nothing, floor}, {floor, nothing}};
  for (const auto& [reference, moving] : pairs) {
    const std::string html = page_of(r, reference, moving);
    CHECK(markup::well_formed(html));
    CHECK(has(html, "Converged on 0 pairs"));
    for (const char* heading : {">Distances before and after<", ">Convergence<", ">Parameters<",
                                ">Residuals<", ">Times<", ">Input<", ">What fixes the pose<"})
      CHECK_MESSAGE(!has(html, heading), heading);
  }
  add_column<double>(r.iteration_log, std::vector<double>{0.02, 0.004, 0.003}, "rms", "m", "",
                     [](double v) { return v; });
  r.parameters_json = R"({"max_iterations": 40})";
  Task task;
  const std::string html = registration_html(
      r, nullptr, nullptr, R"({"title": "<Hall>", "input": {"file": "a"}, "times": {"icp": 2}})",
      {}, task);
  for (const char* text :
       {">Convergence<", ">Parameters<", "max_iterations", ">Times<", ">Input<", "&lt;Hall&gt;"})
    CHECK_MESSAGE(has(html, text), text);
}
