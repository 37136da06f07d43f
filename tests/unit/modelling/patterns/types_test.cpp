// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Openings of one kind, size and form.
#include <doctest/doctest.h>

#include <algorithm>

#include "modelling/patterns/patterns.h"
#include "modelling/patterns/types.h"
#include "unit/modelling/pattern_walls.h"

using namespace jalon;
using namespace jalon::test;

namespace {

FacadeOpening opening(const Vec2& low, const Vec2& size, double coverage = 0.9) {
  FacadeOpening out;
  out.outline = ring_of({low, size}, 0.001);
  out.kind = OpeningKind::kWindow;
  out.evidence = Evidence::kSeenBehind;
  out.coverage = coverage;
  out.residual_m = 0.005;
  return out;
}

FacadeWall wall_with(std::vector<FacadeOpening> openings) {
  FacadeWall out;
  out.spacing_m = 0.02;
  out.sigma_m = 0.002;
  out.openings = std::move(openings);
  return out;
}

}  // namespace

TEST_CASE("pattern_types__of_one_size_kind_and_form_are_one_with_its_best_opening") {
  FacadeOpening door = opening({9, 1}, {1, 1.5}), arch = opening({12, 1}, {1, 1.5});
  door.kind = OpeningKind::kDoor;
  arch.outline.corners[2].v = arch.outline.corners[3].v = 2.2;
  arch.outline.edges[2].sagitta_m = 0.3;  // as high as the others, with a round head
  const FacadeWall wall =
      wall_with({opening({0, 1}, {1, 1.5}), opening({3, 1}, {1.005, 1.495}, 0.95),
                 opening({6, 1}, {1.2, 1.5}), door, arch, opening({15, 1}, {0.99, 1.5})});
  const auto patterns = find_patterns(wall, {});
  REQUIRE(patterns.size() == 4);
  CHECK(patterns[0].best == 1);  // of most coverage
  CHECK(patterns[0].members == std::vector<size_t>{0, 1, 5});
  CHECK(patterns[0].box.width() == doctest::Approx(1.005));
  for (size_t p = 1; p < 4; ++p) {
    CHECK(patterns[p].members == std::vector<size_t>{p + 1});
    CHECK(patterns[p].best == p + 1);
  }
}

TEST_CASE("pattern_types__a_badly_measured_opening_or_a_copy_is_of_none") {
  const FacadeWall wall = wall_with({});
  const PatternSetting setting;
  const FacadeOpening good = opening({0, 1}, {1, 1.5});
  CHECK(is_well_measured(good, wall, setting));
  FacadeOpening shaded = good, ragged = good, copied = good, unknown = good, empty = good;
  shaded.coverage = 0.69;
  ragged.residual_m = 0.02;
  copied.evidence = Evidence::kCopied;
  unknown.evidence = Evidence::kNone;
  empty.outline = {};
  for (const FacadeOpening& o : {shaded, ragged, copied, unknown, empty})
    CHECK(!is_well_measured(o, wall, setting));
  CHECK(find_patterns(wall_with({shaded, copied}), setting).empty());
}

TEST_CASE("pattern_types__the_least_residual_is_best_among_those_seen_alike") {
  std::vector<FacadeOpening> all(3, opening({0, 1}, {1, 1.5}));
  all[2].residual_m = 0.003;
  all[1].residual_m = kNaN;  // not known
  const auto patterns = find_patterns(wall_with(all), {});
  REQUIRE(patterns.size() == 1);
  CHECK(patterns[0].best == 2);
  CHECK(outline_points(all[0].outline) == all[0].outline.corners);
}
