// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Written PLY files byte by byte: header lines and numbers, without the reader.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "formats/files/endian.h"
#include "formats/ply/ply.h"
#include "unit/formats/house.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct PlyParts {
  std::string header, data;
};

PlyParts parts_of(const std::string& bytes) {
  const std::string end = "end_header\n";
  const size_t at = bytes.find(end);
  REQUIRE(at != std::string::npos);
  return {bytes.substr(0, at + end.size()), bytes.substr(at + end.size())};
}

WriteSettings in_form(PlyForm form, int decimals = -1) {
  WriteSettings settings;
  settings.ply_format = form;
  settings.decimals = decimals;
  return settings;
}

PlyParts written_cloud(const Cloud& cloud, const WriteSettings& settings) {
  const Folder folder;
  Task task;
  write_ply(cloud, folder.file("a.ply"), settings, task);
  return parts_of(slurp(folder.file("a.ply")));
}

PlyParts written_model(const Model& model, const WriteSettings& settings) {
  const Folder folder;
  Task task;
  write_ply_model(model, folder.file("a.ply"), settings, task);
  return parts_of(slurp(folder.file("a.ply")));
}

// Names of all properties, in the order of the file.
std::string property_names(const std::string& header) {
  std::string out;
  std::istringstream lines(header);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("property ")) out += line.substr(line.rfind(' '));
  return out;
}

Cloud two_points() {
  Buffer<double> xyz(6);
  const double values[] = {652000.126, -0.001, 1e-7, 1.0 / 3, 2, -3};
  for (size_t i = 0; i < 6; ++i) xyz[i] = values[i];
  return make_cloud(std::move(xyz));
}

}  // namespace

TEST_CASE("ply_writer__binary_records_hold_the_numbers_in_the_order_of_the_header") {
  Cloud cloud = two_points();
  const int64_t wide[] = {-9007199254740992, 7};
  const float normals[] = {0.25f, 0.5f, 0.75f, 1, 0, 0};
  const int16_t pairs[] = {-2, 3, 256, -257};
  cloud.fields.set(make_column<int64_t>({"wide"}, wide));
  cloud.fields.set(make_column<float>({"normal", ElementType::kFloat32, 3}, normals));
  cloud.fields.set(make_column<int16_t>({"a pair", ElementType::kInt16, 2}, pairs));
  cloud.fields.set(make_column<int64_t>({"x"}, wide));
  for (const PlyForm form : {PlyForm::kLittleEndian, PlyForm::kBigEndian}) {
    const bool little = form == PlyForm::kLittleEndian;
    const PlyParts file = written_cloud(cloud, in_form(form));
    CHECK(file.header ==
          std::string("ply\nformat binary_") + (little ? "little" : "big") +
              "_endian 1.0\ncomment Jalon\nelement vertex 2\nproperty double x\nproperty double y\n"
              "property double z\nproperty double wide\nproperty float nx\nproperty float ny\n"
              "property float nz\nproperty short a_pair_0\nproperty short a_pair_1\n"
              "property double x_2\nend_header\n");
    constexpr size_t kRecord = 3 * 8 + 8 + 3 * 4 + 2 * 2 + 8;
    REQUIRE(file.data.size() == 2 * kRecord);
    const auto number = [&](size_t at, auto zero) {
      using T = decltype(zero);
      return little ? load<T>(file.data.data() + at)
                    : load<T, std::endian::big>(file.data.data() + at);
    };
    for (size_t i = 0; i < 2; ++i) {
      const size_t at = i * kRecord;
      for (size_t k = 0; k < 3; ++k) {
        CHECK(number(at + 8 * k, 0.0) == cloud.xyz()[3 * i + k]);
        CHECK(number(at + 32 + 4 * k, 0.0f) == normals[3 * i + k]);
      }
      CHECK(number(at + 24, 0.0) == static_cast<double>(wide[i]));
      CHECK(number(at + 44, int16_t{}) == pairs[2 * i]);
      CHECK(number(at + 46, int16_t{}) == pairs[2 * i + 1]);
      CHECK(number(at + 48, 0.0) == static_cast<double>(wide[i]));
    }
  }
}

TEST_CASE("ply_writer__text_has_the_decimals_that_are_wanted_or_as_many_as_it_takes") {
  Cloud cloud = two_points();
  const uint8_t classes[] = {200, 0};
  cloud.fields.set(make_column<uint8_t>({"class"}, classes));
  cloud.crs = "EPSG:2154";
  const PlyParts whole = written_cloud(cloud, in_form(PlyForm::kAscii));
  CHECK(has_text(whole.header, "comment crs EPSG:2154\n"));
  CHECK(has_text(whole.header, "property uchar class\n"));
  std::istringstream words(whole.data);
  for (size_t i = 0; i < 2; ++i) {
    for (size_t k = 0; k < 3; ++k) {
      double value = 0;
      words >> value;
      CHECK(value == cloud.xyz()[3 * i + k]);
    }
    int value = -1;
    words >> value;
    CHECK(value == classes[i]);
  }
  CHECK(written_cloud(cloud, in_form(PlyForm::kAscii, 2)).data ==
        "652000.13 0.00 0.00 200\n0.33 2.00 -3.00 0\n");  // no minus before zero
  cloud.crs = "EPSG:2154\nend_header";
  CHECK_FALSE(has_text(written_cloud(cloud, in_form(PlyForm::kAscii)).header, "crs"));
}

TEST_CASE("ply_writer__a_model_is_its_faces_as_triangles_and_its_loose_triangles_with_their_ids") {
  Model model = House().model();
  model.triangles = {{0, 1, 2}, {3, 2, 1}};
  model.triangle_faces = {1, 4000000000u};  // the first is drawn as the face of this id
  const PlyParts file = written_model(model, in_form(PlyForm::kAscii));
  std::istringstream head(file.header), words(file.data);
  size_t vertices = 0, faces = 0;
  for (std::string word; head >> word;)
    if (word == "element") {
      head >> word;
      head >> (word == "vertex" ? vertices : faces);
    }
  std::vector<Vec3> points(vertices);
  for (Vec3& p : points) words >> p.x >> p.y >> p.z;
  CHECK(points[0] == model.vertices[0]);
  std::vector<double> area(7, 0);  // by the id of the face
  size_t loose = 0;
  for (size_t f = 0; f < faces; ++f) {
    size_t count = 0, a = 0, b = 0, c = 0, id = 0;
    words >> count >> a >> b >> c >> id;
    REQUIRE(count == 3);
    REQUIRE(std::max({a, b, c}) < vertices);
    const double m2 = norm(cross(points[b] - points[a], points[c] - points[a])) / 2;
    if (id < area.size()) area[id] += m2;
    else loose += id == 4000000000u && a == 3 && b == 2 && c == 1 ? 1 : 100;
  }
  CHECK(loose == 1);
  std::string rest;
  CHECK_FALSE(static_cast<bool>(words >> rest));
  // Arcs of 3 m at most around a face, chords 0.001 m from them.
  for (size_t id = 1; id <= 5; ++id)
    CHECK(std::fabs(area[id] - model.faces[id - 1].area_m2) <= (id <= 2 ? 9 * 0.001 : 1e-6));
}

TEST_CASE("ply_writer__a_number_beyond_what_doubles_hold_is_refused_and_named") {
  Cloud cloud = two_points();
  const uint64_t bad[] = {0, (uint64_t{1} << 53) + 1, 5, 6};
  cloud.fields.set(make_column<uint64_t>({"ids", ElementType::kUint64, 2}, bad));
  const Folder folder;
  Task task;
  const Failure failure = failure_of([&] { write_ply(cloud, folder.file("a.ply"), {}, task); });
  CHECK(failure.status == Status::kUnsupported);
  CHECK(has_text(failure.text, "item 0 of field \"ids\" is beyond 2^53"));
  CHECK(folder.entries() == 0);
}

TEST_CASE("ply_writer__fields_called_like_a_coordinate_or_a_normal_have_names_of_their_own") {
  Cloud cloud = two_points();
  const double values[] = {1, 2};
  const float normals[] = {0.25f, 0.5f, 0.75f, 1, 0, 0};
  for (const char* name : {"x", "nx", "nx_2"})
    cloud.fields.set(make_column<double>({name}, values));
  cloud.fields.set(make_column<float>({"normal", ElementType::kFloat32, 3}, normals));
  cloud.fields.set(make_column<double>({"nz"}, values));
  CHECK(property_names(written_cloud(cloud, {}).header) == " x y z x_2 nx_2 nx_2_2 nx ny nz nz_2");
}
