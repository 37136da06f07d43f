// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/apart.h"

#include <doctest/doctest.h>

#include "unit/registration/joint/joint_street.h"

using namespace jalon;

namespace {

std::string hint_of(double scale, const Vec3& shift) {
  const JointStreet& street = joint_street();
  Model model = street.strips;
  for (Vec3& v : model.vertices) v = v * scale + shift;
  for (Face& face : model.faces)
    face.plane.offset = scale * face.plane.offset + dot(face.plane.normal, shift);
  std::vector<Vec3> points;
  for (uint32_t i = 0; i < street.cloud.size(); ++i) points.push_back(street.cloud.point(i));
  return apart_hint(points, strip_scene(model, false));
}

}  // namespace

TEST_CASE("apart_hint__of_a_model_elsewhere_or_in_another_unit__says_so") {
  CHECK(hint_of(1, {0.3, 0, 0}) == "");
  CHECK(hint_of(1, {652000, 0, 0}).find(" m from the points: are both in one coordinate system?") !=
        std::string::npos);
  CHECK(hint_of(100, {}).find("times as far as the points: are both in one unit?") !=
        std::string::npos);
  CHECK(hint_of(0.01, {}).find("in one unit?") != std::string::npos);
}
