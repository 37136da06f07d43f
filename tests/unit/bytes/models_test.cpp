// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/models.h"

#include <doctest/doctest.h>

#include "unit/bytes/bytes_back.h"

namespace jalon {
namespace {

using test::has_text;

// A square in a tree of three parts, with an arc and covariances.
Model model_of_parts() {
  Model model;
  model.parts.resize(3);
  model.parts[0].parent = 2;  // a parent may come later
  model.parts[1].parent = 0;
  model.parts[1].name = "window 1.1";
  model.parts[1].evidence = Evidence::kDerived;
  Face face;
  face.part = 1;
  model.add_face(face, {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}});
  model.sagittas = {0, 0.1, 0, 0};
  model.vertex_covariances.assign(4, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  model.solids = {{kNoPart, 0, 1}};
  model.triangles = {{0, 1, 2}};
  model.triangle_faces = {77};
  model.crs = "EPSG:2154";
  return model;
}

std::string model_back(const Model& model, Model* out = nullptr) {
  return test::bytes_back([&](ByteWriter& w) { write_model(w, model); },
                          [&](ByteReader& r, Task&) {
                            Model back = read_model(r);
                            if (out != nullptr) *out = std::move(back);
                          });
}

TEST_CASE("model_bytes__bring_back_all_tables") {
  Model back;
  const Model model = model_of_parts();
  CHECK(model_back(model, &back) == "");
  CHECK(back.vertices == model.vertices);
  CHECK(back.vertex_covariances == model.vertex_covariances);
  CHECK(back.corners == model.corners);
  CHECK(back.sagittas == model.sagittas);
  CHECK(back.rings.at(0).count == 4);
  CHECK(back.faces.at(0).part == 1);
  CHECK(back.solids.at(0).face_count == 1);
  CHECK(back.triangles == model.triangles);
  CHECK(back.triangle_faces == model.triangle_faces);
  CHECK(back.parts.at(1).name == "window 1.1");
  CHECK(back.parts[1].evidence == Evidence::kDerived);
  CHECK(back.crs == "EPSG:2154");
  CHECK(model_back(Model()) == "");
}

TEST_CASE("model_bytes__whose_indices_lead_nowhere_are_refused") {
  const auto broken = [](auto&& change) {
    Model model = model_of_parts();
    change(model);
    return model_back(model);
  };
  CHECK(has_text(broken([](Model& m) { m.corners[2] = 4; }), "corner 2 names vertex 4 of 4"));
  CHECK(has_text(broken([](Model& m) { m.faces[0].part = 3; }), "a face is of a part"));
  CHECK(has_text(broken([](Model& m) { m.rings[0].part = 3; }), "a ring is filled by"));
  CHECK(has_text(broken([](Model& m) { m.solids[0].part = 3; }), "a solid is of a part"));
  CHECK(has_text(broken([](Model& m) { m.parts[1].parent = 3; }), "below one that is not there"));
  CHECK(has_text(broken([](Model& m) { m.parts[1].copied_from = 9; }), "repeats one"));
  CHECK(has_text(broken([](Model& m) { m.parts[0].evidence = static_cast<Evidence>(7); }),
                 "evidence 7 is unknown"));
}

TEST_CASE("model_bytes__whose_parts_go_round_are_refused") {
  Model model = model_of_parts();
  model.parts[2].parent = 1;
  CHECK(has_text(model_back(model), "is below itself"));
  model = model_of_parts();
  model.parts[1].parent = 1;
  CHECK(has_text(model_back(model), "part 1 is below itself"));
}

}  // namespace
}  // namespace jalon
