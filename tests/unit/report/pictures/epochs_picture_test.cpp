// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "report/pictures/epochs_picture.h"
#include "unit/report/drawn.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;

namespace {

constexpr DeviationScale kEpochsScale{0.1, false};

std::string picture_of(const std::vector<Vec3>& changed) {
  const Comparison one = page_scenes::comparison_of(std::vector<double>(500, 0.02));
  const EpochPanel panels[] = {{"before", &one}, {"after", &one}};
  Task task;
  return epochs_svg(panels, changed, 0.5, kEpochsScale, task);
}

}  // namespace

TEST_CASE("epochs_picture__has_a_panel_an_epoch_of_one_size_and_one_scale_bar") {
  const std::string svg = picture_of({{1, 0.2, 0}, {3, 0.2, 0}, {3, 0.8, 0}, {1, 0.8, 0}});
  CHECK(markup::well_formed(svg));
  const auto frames = drawn::elements(svg, "rect");
  REQUIRE(frames.size() == 2);
  CHECK(drawn::number(frames[0], "width") == drawn::number(frames[1], "width"));
  CHECK(drawn::number(frames[0], "height") == drawn::number(frames[1], "height"));
  // 2 m of change and half a metre about it either way: the paper has the same scale up.
  CHECK(drawn::number(frames[0], "height") / drawn::number(frames[0], "width") ==
        doctest::Approx(1.6 / 3));
  CHECK(drawn::elements(svg, "image").size() == 2);
  CHECK(drawn::places(svg, "before").size() == 1);
  CHECK(drawn::places(svg, "after").size() == 1);
  CHECK(drawn::places(svg, "X to the right, Y up").size() == 1);
  CHECK(drawn::places(svg, "1 m").size() == 1);
}

TEST_CASE("epochs_picture__an_upright_plane_is_seen_from_before_it_however_it_is_turned") {
  for (const double turn : {0.0, 0.3, 1.2, 2.8}) {
    std::vector<Vec3> wall;
    for (int i = 0; i < 200; ++i) {
      const double along = 0.1 * (i % 20), up = 0.1 * (i / 20);
      wall.push_back({2 + along * std::cos(turn), 0.5 + along * std::sin(turn), up});
    }
    const std::string svg = picture_of(wall);
    CAPTURE(turn);
    const auto frames = drawn::elements(svg, "rect");
    // 1.9 m wide and 0.9 m high.
    CHECK(drawn::number(frames.at(0), "height") / drawn::number(frames.at(0), "width") ==
          doctest::Approx(1.9 / 2.9));
    CHECK(drawn::places(svg, "seen from the side, Z up").size() == 1);
  }
}

TEST_CASE("epochs_picture__where_an_epoch_has_no_point_its_panel_is_empty") {
  const std::string svg = picture_of({{100, 100, 0}, {101, 100, 0}, {101, 101, 0}});
  CHECK(markup::well_formed(svg));
  CHECK(drawn::elements(svg, "image").empty());
  CHECK(drawn::elements(svg, "rect").size() == 2);
}
