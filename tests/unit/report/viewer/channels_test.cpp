// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/viewer/channels.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "unit/report/viewer/viewed.h"

using namespace jalon;

namespace {

template <class T>
ViewCloud view_of(size_t n, std::initializer_list<const char*> names, T (*value)(size_t, size_t)) {
  Cloud cloud = *viewed::random_cloud(n, 1, {0, 0, 0}, 1);
  size_t k = 0;
  for (const char* name : names) {
    std::vector<T> values(n);
    for (size_t i = 0; i < n; ++i) values[i] = value(i, k);
    ++k;
    cloud.fields.set(make_column<T>({name}, std::span<const T>(values)));
  }
  ViewCloud view;
  view.cloud = std::make_shared<const Cloud>(std::move(cloud));
  add_field_channels(view);
  return view;
}

}  // namespace

TEST_CASE("viewer_channels__intensity_is_grey_between_its_usual_values") {
  const ViewCloud view = view_of<float>(
      1000, {"intensity"}, [](size_t i, size_t) { return i == 7 ? 1e6f : static_cast<float>(i); });
  REQUIRE(view.channels.size() == 1);
  CHECK(view.channels[0].name == "intensity");
  CHECK(view.channels[0].low == doctest::Approx(20).epsilon(0.1));
  CHECK(view.channels[0].high == doctest::Approx(979).epsilon(0.01));
  CHECK(view_of<float>(10, {"intensity"}, [](size_t, size_t) { return 5.0f; }).channels.empty());
}

TEST_CASE("viewer_channels__colours_of_8_and_16_bits_and_of_floats_come_out_alike") {
  const auto eight = view_of<uint8_t>(4, {"red", "green", "blue"}, [](size_t i, size_t k) {
    return static_cast<uint8_t>(60 * i + k);
  });
  const auto sixteen = view_of<uint16_t>(4, {"red", "green", "blue"}, [](size_t i, size_t k) {
    return static_cast<uint16_t>((60 * i + k) << 8 | 200);
  });
  const auto floats = view_of<float>(4, {"red", "green", "blue"}, [](size_t i, size_t k) {
    return (static_cast<float>(60 * i + k) + 0.25f) / 255;
  });
  for (size_t i = 0; i < 4; ++i) {
    const double wanted = static_cast<double>((60 * i) << 16 | (60 * i + 1) << 8 | (60 * i + 2));
    for (const ViewCloud* view : {&eight, &sixteen, &floats})
      CHECK(view->channels.at(0).value(i) == wanted);
  }
}

TEST_CASE("viewer_channels__a_box_leaves_strays_out") {
  Cloud cloud = *viewed::random_cloud(10000, 1, {0, 0, 0}, 2);
  Buffer<double> xyz(3 * cloud.size());
  for (size_t i = 0; i < xyz.size(); ++i) xyz[i] = cloud.xyz()[i];
  xyz[0] = 5000;
  const Box3 box = box_without_strays(make_cloud(std::move(xyz)), {});
  CHECK(box.max.x < 1.001);
  CHECK(box.max.x > 0.9);
  CHECK(box_without_strays(Cloud{}, {}).empty());
}
