// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "model/model.h"

using namespace jalon;

namespace {

Model square_with_hole() {
  Model model;
  Face face;
  face.id = 4;
  model.parts.push_back({"facade", "facade", kNoParent});
  model.add_face(face,
                 {{{0, 0, 0}, {4, 0, 0}, {4, 0, 4}, {0, 0, 4}}, {{1, 0, 1}, {1, 0, 2}, {2, 0, 2}}});
  return model;
}

bool is_refused(const Model& model) {
  try {
    validate(model);
    return false;
  } catch (const Error& error) {
    return error.status() == Status::kInvalidArgument;
  }
}

}  // namespace

TEST_CASE("model: faces keep their rings and corners") {
  Model model = square_with_hole();
  CHECK(model.add_face({}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}) == 1);
  validate(model);
  REQUIRE(model.rings.size() == 3);
  CHECK(model.faces[0].ring_count == 2);
  CHECK(model.faces[1].first_ring == 2);
  CHECK(model.rings[1].first == 4);
  CHECK(model.rings[1].count == 3);
  CHECK(model.vertices[model.corners[model.rings[1].first + 1]] == Vec3{1, 0, 2});
}

TEST_CASE("model: impossible indices and coordinates are refused") {
  CHECK(!is_refused(Model{}));
  CHECK(!is_refused(square_with_hole()));
  Model model = square_with_hole();
  model.vertices[2].y = NAN;
  CHECK(is_refused(model));
  model = square_with_hole();
  model.corners[3] = 7;
  CHECK(is_refused(model));
  model = square_with_hole();
  model.rings[1].count = 4;
  CHECK(is_refused(model));
  model = square_with_hole();
  model.rings[1].first = ~uint64_t{0};
  CHECK(is_refused(model));
  model = square_with_hole();
  model.faces[0].ring_count = ~uint64_t{0};
  CHECK(is_refused(model));
  model = square_with_hole();
  model.triangles.push_back({0, 1, 99});
  model.triangle_faces.push_back(0);
  CHECK(is_refused(model));
  model = square_with_hole();
  model.triangles.push_back({0, 1, 2});
  CHECK(is_refused(model));
}
