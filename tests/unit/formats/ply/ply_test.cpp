// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "formats/files/endian.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Model read_mesh(const std::string& path) {
  Task task;
  return read_model(path, {}, task);
}

}  // namespace

TEST_CASE("ply__round_trip_in_three_encodings_keeps_every_type") {
  const Folder folder;
  size_t columns = 0;
  for (uint64_t seed = 0; seed < 30; ++seed) {
    RandomStream random(seed, 9);
    const size_t n = seed == 0 ? 0 : 1 + random.below(2000);
    Cloud cloud = random_points(n, seed);
    for (int32_t type = 1; type <= 10; ++type)
      if (type != 7 && type != 8)
        cloud.fields.set(random_column(std::to_string(type).insert(0, 1, 'f'),
                                       static_cast<ElementType>(type), 1, n, random));
    cloud.fields.set(random_column("normal", ElementType::kFloat32, 3, n, random));
    cloud.crs = seed % 2 == 0 ? "EPSG:2154" : "";
    WriteSettings settings;
    settings.ply_format = seed % 3 == 0   ? PlyForm::kAscii
                          : seed % 3 == 1 ? PlyForm::kLittleEndian
                                          : PlyForm::kBigEndian;
    write(cloud, folder.file("a.ply"), settings);
    const Cloud back = read(folder.file("a.ply"));
    REQUIRE(back.size() == n);
    CHECK(back.crs.str() == cloud.crs.str());
    for (size_t i = 0; i < 3 * n; ++i) REQUIRE(back.xyz()[i] == cloud.xyz()[i]);
    for (const ColumnPtr& column : cloud.fields) {
      const Column& other = back.fields.require(column->info().name);
      CHECK(other.info().type == column->info().type);
      CHECK_MESSAGE(same_values(*column, other), "seed ", seed, " ", column->info().name);
      ++columns;
    }
  }
  MESSAGE("columns compared: ", columns);
}

TEST_CASE("ply__64_bit_integers_are_exact_or_refused") {
  const Folder folder;
  Cloud cloud = random_points(1, 1);
  const int64_t good[] = {-(int64_t{1} << 53)}, bad[] = {(int64_t{1} << 53) + 1};
  cloud.fields.set(make_column<int64_t>({"id"}, good));
  write(cloud, folder.file("a.ply"));
  CHECK(read(folder.file("a.ply")).fields.require("id").number(0) == -0x1p53);
  cloud.fields.set(make_column<int64_t>({"id"}, bad));
  CHECK(failure_of([&] { write(cloud, folder.file("a.ply")); }).status == Status::kUnsupported);
  CHECK(read(folder.file("a.ply")).fields.require("id").number(0) ==
        -0x1p53);  // the good file is still there
}

TEST_CASE("ply__lists_and_other_elements_are_passed_over") {
  const Folder folder;
  spill(folder.file("a.ply"),
        "ply\nformat ascii 1.0\nelement camera 2\nproperty list uchar float m\nproperty int "
        "k\nelement vertex 2\nproperty uchar x\n"
        "property list int short tags\nproperty float y\nproperty double z\nproperty uchar "
        "red\nelement face 1\nproperty list uchar int vertex_indices\n"
        "end_header\n2 1.5 2.5 7\n0 8\n1 3 5 6 7 2 3 200\n4 0 5 6 201\n3 0 1 1\n");
  const Cloud cloud = read(folder.file("a.ply"));
  REQUIRE(cloud.size() == 2);
  CHECK(cloud.point(0) == Vec3{1, 2, 3});
  CHECK(cloud.point(1) == Vec3{4, 5, 6});
  CHECK(cloud.fields.require("red").number(1) == 201);
  CHECK(cloud.fields.size() == 1);
}

TEST_CASE("ply__binary_lists_inside_vertices_are_passed_over") {
  const Folder folder;
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty float x\nproperty list ushort "
      "int l\nproperty float y\nproperty float z\nend_header\n";
  const auto put = [&](auto value) {
    char raw[sizeof value];
    store<decltype(value), std::endian::big>(raw, value);
    bytes.append(raw, sizeof raw);
  };
  put(1.f), put(uint16_t{2}), put(int32_t{5}), put(int32_t{6}), put(2.f), put(3.f);
  put(4.f), put(uint16_t{0}), put(5.f), put(6.f);
  spill(folder.file("a.ply"), bytes);
  const Cloud cloud = read(folder.file("a.ply"));
  CHECK(cloud.point(0) == Vec3{1, 2, 3});
  CHECK(cloud.point(1) == Vec3{4, 5, 6});
  spill(folder.file("b.ply"), bytes.substr(0, bytes.size() - 1));
  CHECK(failure_of([&] { read(folder.file("b.ply")); }).status == Status::kFormat);
}

TEST_CASE("ply__lying_counts_are_refused_with_offset_and_reason") {
  const Folder folder;
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\nproperty double "
      "x\nproperty double y\nproperty double z\nend_header\n";
  spill(folder.file("a.ply"), header + "abc");
  const Failure failure = failure_of([&] { read(folder.file("a.ply")); });
  CHECK(failure.status == Status::kFormat);
  CHECK(failure.text.find(std::to_string(header.size()) +
                          ": the header promises 18446744073709551615") != std::string::npos);
}

TEST_CASE("ply__shared_scans_load") {
  for (const auto& [name, points] :
       {std::pair{"registration/source.ply", 69792}, std::pair{"registration/target.ply", 69088}}) {
    const std::string path = shared(name);
    if (path.empty()) return;
    const Cloud cloud = read(path);
    CHECK(cloud.size() == static_cast<size_t>(points));
    CHECK(cloud.fields.find("intensity") != nullptr);
    MESSAGE(std::string(name), ": ", cloud.size(), " points");
  }
}

TEST_CASE("ply__mesh_round_trip_in_three_encodings") {
  const Folder folder;
  Model model;
  model.vertices = {{652000.125, 6861000.1, 0},
                    {652001, 6861000, 0},
                    {652001, 6861001, 0},
                    {652000, 6861001, 1e-17}};
  model.triangles = {{0, 1, 2}, {0, 2, 3}};
  model.triangle_faces = {7, 9};
  for (const PlyForm form : {PlyForm::kLittleEndian, PlyForm::kBigEndian, PlyForm::kAscii}) {
    WriteSettings settings;
    settings.ply_format = form;
    Task task;
    write_model(model, folder.file("a.ply"), settings, task);
    const Model back = read_mesh(folder.file("a.ply"));
    CHECK(back.vertices == model.vertices);
    CHECK(back.triangles == model.triangles);
  }
}

TEST_CASE("ply__faces_with_wrong_vertices_are_refused") {
  const Folder folder;
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  spill(folder.file("a.ply"), head + "3 0 1 3\n");
  CHECK(failure_of([&] {
          read_mesh(folder.file("a.ply"));
        }).text.find("face 0 names vertex 3 of 3") != std::string::npos);
  spill(folder.file("a.ply"), head + "3 0 1 -1\n");
  CHECK(failure_of([&] { read_mesh(folder.file("a.ply")); }).status == Status::kFormat);
  spill(folder.file("a.ply"), head + "255 0 1 2\n");
  CHECK(failure_of([&] { read_mesh(folder.file("a.ply")); }).status == Status::kFormat);
  spill(folder.file("a.ply"), head + "3 0 1 2\n");
  CHECK(read_mesh(folder.file("a.ply")).triangles.size() == 1);
}
