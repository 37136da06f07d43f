// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/lines/straight_pieces.h"

#include <doctest/doctest.h>

#include "unit/segment/lines/scanned.h"
#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("straight_pieces__are_cut_at_corners_and_keep_within_the_tolerance") {
  RandomStream random(5, 0);
  std::vector<Vec3> chain;
  for (int i = 0; i <= 20; ++i) chain.push_back({0.1 * i, 0, 1});
  for (int i = 1; i <= 20; ++i) chain.push_back({2, 0.1 * i, 1});
  CHECK(straight_cuts(chain, 0.01) == std::vector<uint32_t>{0, 20, 40});
  CHECK(straight_cuts({chain.data(), 1}, 0.01).empty());
  for (Vec3& p : chain) p += 0.3 * Vec3{random.normal(), random.normal(), random.normal()};
  const auto cuts = straight_cuts(chain, 0.2);
  for (size_t k = 0; k + 1 < cuts.size(); ++k)
    for (uint32_t i = cuts[k]; i <= cuts[k + 1]; ++i) {
      const Vec3 chord = normalized(chain[cuts[k + 1]] - chain[cuts[k]]);
      CHECK(norm(cross(chain[i] - chain[cuts[k]], chord)) <= 0.2 + 1e-12);
    }
}

TEST_CASE("straight_pieces__of_a_scanned_house_lie_on_one_face_each") {
  const Scanned scanned(scanned_house(), 0.01, 0.002, 3);
  MadeScene made(scanned.scene.points);
  std::vector<uint32_t> positions(made.scene.size());
  for (uint32_t p = 0; p < positions.size(); ++p) positions[made.point(p)] = p;
  const auto places = scan_places(*scanned.cloud(true), made.task);
  const auto lines = straight_pieces(made.scene, places, positions, {}, made.task);
  size_t points = 0, pure = 0;
  for (const ScanLine& line : lines) {
    points += line.moments.n;
    CHECK(line.moments.n == line.last - line.first);
    size_t same = 0;
    const auto face = [&](uint32_t i) { return scanned.scene.faces[places[i].point]; };
    for (uint32_t i = line.first; i < line.last; ++i)
      same += face(i) == face((line.first + line.last) / 2);
    pure += same + 2 >= line.moments.n;
  }
  CHECK(static_cast<double>(points) > 0.9 * static_cast<double>(places.size()));
  CHECK(static_cast<double>(pure) > 0.9 * static_cast<double>(lines.size()));
}
