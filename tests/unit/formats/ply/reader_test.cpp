// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// PLY files put together by hand: three encodings of one cloud are one cloud; meshes and what stands between.
#include <doctest/doctest.h>

#include <bit>
#include <string>
#include <vector>

#include "formats/files/endian.h"
#include "formats/ply/ply.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Cloud ply_cloud(const std::string& bytes) {
  const OpenedFile file(bytes, "a.ply");
  Task task;
  return read_ply(file, {}, task);
}

Model ply_model(const std::string& bytes) {
  const OpenedFile file(bytes, "a.ply");
  Task task;
  return read_ply_model(file, {}, task);
}

template <class F>
std::string refused_ply(F&& read_it) {
  const Failure failure = failure_of(read_it);
  CHECK(failure.status == Status::kFormat);
  return failure.text;
}

/// Appends numbers in one of the three encodings.
class PlyData {
 public:
  explicit PlyData(std::string format) : format_(std::move(format)) {}
  std::string text;

  template <class T>
  void put(T value) {
    if (format_ == "ascii") {
      text += std::to_string(value) + " ";
      return;
    }
    char raw[sizeof value];
    if (format_ == "binary_big_endian") store<T, std::endian::big>(raw, value);
    else store<T>(raw, value);
    text.append(raw, sizeof raw);
  }

 private:
  std::string format_;
};

const std::string kAscii = "ply\nformat ascii 1.0\n";
const std::string kFourCorners =
    "element vertex 4\nproperty int x\nproperty int y\nproperty int z\n";
const std::string kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

}  // namespace

TEST_CASE("ply_reader__three_encodings_with_and_without_lists_give_the_same_cloud") {
  constexpr size_t kPoints = 33000;  // more than a chunk of 32768, many blocks of 96 KiB
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"})
    for (const bool with_list : {false, true}) {
      CAPTURE(format);
      CAPTURE(with_list);
      const size_t n = with_list || format == "ascii" ? 300 : kPoints;  // those are read one by one
      PlyData data(format);
      for (size_t i = 0; i < n; ++i) {
        data.put(static_cast<float>(i) / 4);
        data.put(static_cast<uint16_t>(i));
        if (with_list) {
          data.put(static_cast<uint8_t>(i % 3));
          for (size_t k = 0; k < i % 3; ++k) data.put(int32_t{-1});
        }
        data.put(-static_cast<double>(i));
        data.put(static_cast<int16_t>(5 - static_cast<int>(i % 11)));
        data.put(static_cast<int32_t>(i) * -3);
      }
      const Cloud cloud = ply_cloud("ply\nformat " + format + " 1.0\nelement vertex " +
                                    std::to_string(n) + "\nproperty float x\nproperty ushort id\n" +
                                    (with_list ? "property list uchar int skipped\n" : "") +
                                    "property double z\nproperty short class\nproperty int y\n"
                                    "end_header\n" +
                                    data.text);
      REQUIRE(cloud.size() == n);
      REQUIRE(cloud.fields.size() == 2);
      const auto ids = cloud.fields.require("id").values<uint16_t>();
      const auto classes = cloud.fields.require("class").values<int16_t>();
      size_t wrong = 0;
      for (size_t i = 0; i < n; ++i) {
        const auto at = static_cast<double>(i);
        wrong += cloud.point(i) == Vec3{at / 4, -3 * at, -at} && ids[i] == i % 65536 &&
                         classes[i] == 5 - static_cast<int>(i % 11)
                     ? 0
                     : 1;
      }
      CHECK(wrong == 0);
    }
}

TEST_CASE("ply_reader__fields_have_the_names_of_the_properties_or_the_usual_ones") {
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const Cloud cloud =
      ply_cloud(kAscii + "comment Created by CloudCompare\nelement vertex 1\n" + xyz +
                "property float nz\nproperty float nx\nproperty float ny\nproperty int scalar_a\n"
                "property int a\nproperty int scalar_\nproperty int normal\nend_header\n1 2 3 9 7 "
                "8 4 5 6 1\n");
  CHECK(cloud.fields.require("normal").number(0, 0) == 7);
  CHECK(cloud.fields.require("normal").number(0, 2) == 9);
  CHECK(cloud.fields.require("a").number(0) == 4);
  CHECK(cloud.fields.require("a_2").number(0) == 5);
  CHECK(cloud.fields.require("scalar_").number(0) == 6);
  CHECK(cloud.fields.require("normal_2").number(0) == 1);
  CHECK(cloud.fields.size() == 5);
  const Cloud half = ply_cloud(kAscii + "element vertex 1\n" + xyz +
                               "property int scalar_a\nproperty float nx\nend_header\n1 2 3 4 5\n");
  CHECK(half.fields.require("scalar_a").number(0) == 4);  // of another program
  CHECK(half.fields.require("nx").number(0) == 5);        // no normal has one component
  CHECK(has_text(refused_ply([&] {
                   ply_cloud(kAscii + "element vertex 0\n" + xyz + "property int y\nend_header\n");
                 }),
                 "the vertices need one property y"));
  CHECK(has_text(refused_ply([&] {
                   ply_cloud(kAscii + "element vertex 2\n" + xyz + "end_header\n1 2 3\n4 5 0x6\n");
                 }),
                 "no number of the property's type"));
  const OpenedFile whole(kAscii), longer("plyx\n"), old("ply\r\n");
  CHECK(is_ply(whole));
  CHECK(is_ply(old));
  CHECK_FALSE(is_ply(longer));
}

TEST_CASE("ply_reader__without_vertices_gives_a_cloud_with_the_other_fields_alone") {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    CAPTURE(format);
    const Cloud cloud =
        ply_cloud(std::string("ply\nformat ") + format +
                  " 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                  "property float nx\nproperty float ny\nproperty float nz\nproperty uchar label\n"
                  "end_header\n");
    CHECK(cloud.size() == 0);
    CHECK(cloud.fields.find("x") == nullptr);
    CHECK(cloud.fields.find("nx") == nullptr);
    CHECK(cloud.fields.find("normal") != nullptr);
    CHECK(cloud.fields.find("label") != nullptr);
  }
}

TEST_CASE("ply_reader__faces_become_triangles_whatever_stands_between_and_beside_the_lists") {
  const Model model = ply_model(
      kAscii + kFourCorners + "property uchar red\nelement edge 2\nproperty list int int v\n" +
      "element face 3\nproperty uchar flags\nproperty list uchar uint vertex_index\n"
      "property list uchar float uv\nend_header\n" +
      "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n2 0 1\n1 2\n9 4 0 1 2 3 2 0.5 0.5\n9 3 2 1 0 0\n"
      "9 2 0 1 0\n");
  CHECK(model.vertices.size() == 4);
  CHECK(model.triangle_faces == std::vector<uint32_t>{0, 0, 1});  // two corners are no face
  Vec3 twice;
  for (size_t t = 0; t < 2; ++t) {
    const auto corner = [&](size_t k) { return model.vertices[model.triangles[t][k]]; };
    twice += cross(corner(1) - corner(0), corner(2) - corner(0));
  }
  CHECK(norm(twice - Vec3{0, 0, 2}) <= 1e-15);
  CHECK(model.triangles[2] == std::array<uint32_t, 3>{2, 1, 0});
}

TEST_CASE("ply_reader__meshes_that_are_none_are_refused_with_the_reason") {
  const auto reason = [](const std::string& header, const std::string& data) {
    return refused_ply([&] { ply_model(kAscii + header + "end_header\n" + data); });
  };
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  CHECK(has_text(reason(kFourCorners, kSquare), "no faces; it is a cloud"));
  CHECK(has_text(reason(faces, "3 0 1 2\n"), "no vertices"));
  CHECK(has_text(reason(faces + kFourCorners, "3 0 1 2\n" + kSquare), "faces before their"));
  CHECK(has_text(reason(kFourCorners + "element face 1\nproperty list uchar int corners\n",
                        kSquare + "3 0 1 2\n"),
                 "no list vertex_indices"));
  CHECK(
      has_text(reason(kFourCorners + faces, kSquare + "3 0 1 4\n"), "face 0 names vertex 4 of 4"));
  CHECK(has_text(reason(kFourCorners + faces, kSquare + "3 0 1\n"), "ends too early"));
  CHECK(has_text(reason(kFourCorners + faces, kSquare + "3 0 1 1.5\n"), "no number of the"));
  CHECK(has_text(
      reason("element vertex 1\nproperty float x\nproperty float y\nproperty float z\n" + faces,
             "0 nan 0\n3 0 0 0\n"),
      "vertex 0 is not finite"));
}
