// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/segmentations.h"

#include <doctest/doctest.h>

#include "unit/bytes/bytes_back.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using test::has_text;

// Four points: noise, a plane, a sphere, a cylinder.
Segmentation one_of_each() {
  Segmentation s;
  s.cloud =
      std::make_shared<const Cloud>(test::cloud_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
  s.labels = make_column<uint32_t>({"label"}, std::vector<uint32_t>{0, 1, 2, 3});
  s.residuals = make_column<float>({"residual"}, std::vector<float>{NAN, 0.1f, -0.1f, 0});
  s.orientations = make_column<uint8_t>({"orientation"}, std::vector<uint8_t>{0, 4, 0, 0});
  s.segments.resize(3);
  for (uint32_t i = 0; i < 3; ++i) {
    s.segments[i].label = i + 1;
    s.segments[i].source_label = -5 - static_cast<int64_t>(i);
    s.segments[i].type = static_cast<PrimitiveType>(i + 1);
  }
  s.segments[0].orientation = Orientation::kInclined;
  s.segments[0].front_source = FrontSource::kEvidence;
  s.segments[0].front_confidence = 0.75;
  s.segments[0].fit.axis_u = {1, 0, 0};
  s.segments[0].fit.axis_v = {0, 1, 0};
  s.segments[1].sphere.sphere.radius = 0.3;
  s.segments[2].cylinder.cylinder.radius = 0.2;
  s.parameters_json = "{\"a\":1}";
  return s;
}

std::string segmentation_back(const Segmentation& from, Segmentation* out = nullptr) {
  return test::bytes_back([&](ByteWriter& w) { write_segmentation(w, from); },
                          [&](ByteReader& r, Task& task) {
                            Segmentation back = read_segmentation(r, task);
                            if (out != nullptr) *out = std::move(back);
                          });
}

template <class F>
std::string broken_segmentation(F&& change) {
  Segmentation s = one_of_each();
  change(s);
  return segmentation_back(s);
}

TEST_CASE("segmentation_bytes__bring_back_notes_and_read_bytes_that_have_none") {
  Segmentation coded = one_of_each(), back;
  coded.notes_json = "{\"objects\":[]}";
  CHECK(segmentation_back(coded, &back) == "");
  CHECK(back.notes_json == coded.notes_json);
  CHECK(segmentation_back(one_of_each(), &back) == "");
  CHECK(back.notes_json == "");
}

TEST_CASE("segmentation_bytes__bring_back_labels_segments_and_parameters") {
  Segmentation back;
  CHECK(segmentation_back(one_of_each(), &back) == "");
  CHECK(back.cloud->size() == 4);
  CHECK(back.labels->values<uint32_t>()[3] == 3);
  CHECK(back.residuals->values<float>()[2] == -0.1f);
  CHECK(back.segments.at(0).source_label == -5);
  CHECK(back.segments.at(0).front_source == FrontSource::kEvidence);
  CHECK(back.segments.at(0).front_confidence == 0.75);
  CHECK(back.segments.at(1).sphere.sphere.radius == 0.3);
  CHECK(back.segments.at(2).cylinder.cylinder.radius == 0.2);
  CHECK(back.parameters_json == "{\"a\":1}");
}

TEST_CASE("segmentation_bytes__with_labels_of_no_segment_are_refused") {
  using S = Segmentation;
  CHECK(has_text(broken_segmentation([](S& s) { s.segments.pop_back(); }),
                 "the label of a segment that is not there"));
  CHECK(has_text(broken_segmentation([](S& s) { s.segments[1].label = 9; }),
                 "segment 1 has the label 9"));
  CHECK(
      has_text(broken_segmentation([](S& s) {
                 s.labels = make_column<uint32_t>({"label"}, std::vector<uint32_t>{0, 1});
                 s.residuals = make_column<float>({"residual"}, std::vector<float>{0, 1});
                 s.orientations = make_column<uint8_t>({"orientation"}, std::vector<uint8_t>{0, 1});
               }),
               "2 rows where there must be 4"));
  CHECK(has_text(
      broken_segmentation([](S& s) {
        s.orientations = make_column<uint8_t>({"orientation"}, std::vector<uint8_t>{0, 5, 0, 0});
      }),
      "an orientation that is none"));
}

TEST_CASE("segmentation_bytes__with_surfaces_that_cannot_be_are_refused") {
  using S = Segmentation;
  const char* const kNone = "is no plane, sphere or cylinder that there can be";
  CHECK(has_text(broken_segmentation([](S& s) {
                   s.segments[0].fit.plane.normal = {0, 0, 2};
                 }),
                 kNone));
  CHECK(has_text(broken_segmentation([](S& s) {
                   s.segments[0].fit.axis_u = {1e300, 0, 0};
                 }),
                 kNone));
  CHECK(has_text(broken_segmentation([](S& s) { s.segments[0].fit.centroid.x = NAN; }), kNone));
  CHECK(has_text(broken_segmentation([](S& s) { s.segments[1].sphere.sphere.radius = INFINITY; }),
                 kNone));
  CHECK(has_text(broken_segmentation([](S& s) { s.segments[2].cylinder.cylinder.direction = {}; }),
                 kNone));
  CHECK(has_text(
      broken_segmentation([](S& s) { s.segments[2].type = static_cast<PrimitiveType>(4); }),
      kNone));
  // A given label whose points make no plane is one all the same.
  CHECK(broken_segmentation([](S& s) {
          s.segments[0].fit.plane = {{NAN, NAN, NAN}, NAN};
          s.segments[0].fit.centroid = {NAN, NAN, NAN};
        }) == "");
}

TEST_CASE("segmentation_bytes__with_a_frame_that_is_no_rigid_motion_are_refused") {
  const char* const kNone = "the facade's frame is no rigid motion";
  CHECK(
      has_text(broken_segmentation([](Segmentation& s) { s.T_facade_world.m[0] = 1e200; }), kNone));
  CHECK(has_text(broken_segmentation([](Segmentation& s) { s.T_facade_world.m[3] = NAN; }), kNone));
}

}  // namespace
}  // namespace jalon
