// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The bytes of a file against the tables of glTF 2.0: chunks, bounds, the tree, places turned back to the model's.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "formats/files/endian.h"
#include "formats/glb/glb.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct File {
  nlohmann::json json;
  std::string bytes;
};

File written(const Model& model) {
  const Folder folder;
  Task task;
  write_glb(model, folder.file("a.glb"), {}, task);
  const std::string all = slurp(folder.file("a.glb"));
  const auto word = [&](size_t at) { return load<uint32_t>(all.data() + at); };
  REQUIRE(all.substr(0, 4) == "glTF");
  CHECK(word(4) == 2);
  CHECK(word(8) == all.size());
  CHECK(all.size() % 4 == 0);
  const size_t length = word(12);
  CHECK(all.substr(16, 4) == "JSON");
  File out{nlohmann::json::parse(all.substr(20, length)), ""};
  if (20 + length < all.size()) {
    CHECK(all.substr(24 + length, 3) == "BIN");
    out.bytes = all.substr(28 + length, word(20 + length));
  }
  return out;
}

Model wall(const Vec3& o) {
  Model model;
  model.crs = "EPSG:2154";
  model.parts = {{"house", "building"},
                 {"wall <1>", "wall", 0},
                 {"window", "window", 1},
                 {"unseen", "door", 1}};
  model.parts[2].width_m = 1;
  model.parts[2].evidence = Evidence::kRevealed;
  Face face;
  face.part = 1;
  face.plane = {{0, -1, 0}, 0};
  model.add_face(face,
                 {{o, o + Vec3{4, 0, 0}, o + Vec3{4, 0, 3}, o + Vec3{0, 0, 3}},
                  {o + Vec3{1, 0, 1}, o + Vec3{1, 0, 2}, o + Vec3{2, 0, 2}, o + Vec3{2, 0, 1}}});
  model.rings[1].part = 2;
  return model;
}

}  // namespace

TEST_CASE("glb_writer__places_come_back_through_the_matrix_of_the_root") {
  const Vec3 o{652000.5, 6861000.25, 100.125};
  const File file = written(wall(o));
  const auto& json = file.json;
  CHECK(json["asset"]["version"] == "2.0");
  const std::vector<double> m = json["nodes"][0]["matrix"];
  const auto& primitive = json["meshes"][0]["primitives"][0];
  const auto& accessor = json["accessors"][primitive["attributes"]["POSITION"].get<size_t>()];
  const auto& view = json["bufferViews"][accessor["bufferView"].get<size_t>()];
  const size_t at = view["byteOffset"];
  Box3 box;
  for (size_t i = 0; i < accessor["count"]; ++i) {
    Vec3 p;
    for (size_t k = 0; k < 3; ++k)
      p[static_cast<int>(k)] = load<float>(file.bytes.data() + at + 12 * i + 4 * k);
    // glTF's Y is up: its (x, y, z) are the model's (x, z, -y).
    Vec3 world;
    for (size_t k = 0; k < 3; ++k)
      world[static_cast<int>(k)] = m[k] * p.x + m[4 + k] * p.y + m[8 + k] * p.z + m[12 + k];
    box.add({world.x, -world.z, world.y});
  }
  CHECK(norm(box.min - o) < 1e-6);
  CHECK(norm(box.max - (o + Vec3{4, 0, 3})) < 1e-6);
  CHECK(accessor["min"][0].get<double>() == 0.5);
  CHECK(json["buffers"][0]["byteLength"] == file.bytes.size());
  CHECK(json["nodes"][0]["extras"]["crs"] == "EPSG:2154");
}

TEST_CASE("glb_writer__the_tree_holds_what_is_seen_with_what_is_known_of_it") {
  const auto json = written(wall({0, 0, 0})).json;
  REQUIRE(json["nodes"].size() == 4);  // root, house, wall, window; nothing is seen of the door
  CHECK(json["nodes"][0]["children"] == std::vector<int>{1});
  CHECK(json["nodes"][1]["children"] == std::vector<int>{2});
  CHECK(json["nodes"][2]["name"] == "wall <1>");
  const auto& window = json["nodes"][3];
  CHECK(window["extras"]["class"] == "window");
  CHECK(window["extras"]["evidence"] == "revealed");
  CHECK(window["extras"]["width_m"] == 1);
  CHECK_FALSE(window["extras"].contains("height_m"));
  CHECK(json["meshes"][window["mesh"].get<size_t>()]["primitives"][0]["mode"] == 1);
}

TEST_CASE("glb_writer__an_empty_model_is_a_file_without_a_scene_and_rings_of_parents_end") {
  CHECK(written({}).json.size() == 1);
  Model model = wall({0, 0, 0});
  model.parts[0].parent = 1;
  const auto json = written(model).json;
  CHECK(json["nodes"][0]["children"].size() == 2);
}
