// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Which form of each ring, so that openings lie inside and apart.
#include <doctest/doctest.h>

#include "modelling/edges/join/nesting.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

namespace {

RingForms forms_of(const std::vector<VectorRing>& all) {
  RingForms out;
  for (const VectorRing& ring : all) out.add(ring, 0.001);
  return out;
}

}  // namespace

TEST_CASE("nested: a form that leaves the outline gives way to the next") {
  const RingForms outline = forms_of({rectangle({0, 0}, {4, 4})});
  const RingForms opening = forms_of({hole({3, 1}, {5, 2}), hole({1, 1}, {2, 2})});
  const std::vector<RingForms> all{outline, opening};
  CHECK(nested(all) == std::vector<size_t>{0, 1});
}

TEST_CASE("nested__wanted_forms_without_a_conflict_are_kept") {
  const std::vector<RingForms> all{forms_of({rectangle({0, 0}, {9, 4}), rectangle({0, 0}, {8, 4})}),
                                   forms_of({hole({1, 1}, {2, 2}), hole({1, 1}, {1.9, 2})}),
                                   forms_of({hole({3, 1}, {4, 2})})};
  CHECK(nested(all) == std::vector<size_t>{0, 0, 0});
  CHECK(nested(std::vector<RingForms>{all[0]}) == std::vector<size_t>{0});
}

TEST_CASE("nested__the_outline_gives_way_where_an_opening_has_no_other_form") {
  const std::vector<RingForms> all{forms_of({rectangle({0, 0}, {3, 4}), rectangle({0, 0}, {8, 4})}),
                                   forms_of({hole({2, 1}, {4, 2})})};
  CHECK(nested(all) == std::vector<size_t>{1, 0});
}

TEST_CASE("nested__openings_over_or_within_each_other_step_down_until_they_are_apart") {
  const RingForms outline = forms_of({rectangle({0, 0}, {9, 4})});
  const RingForms small = forms_of({hole({1, 1}, {2, 2})});
  const RingForms over =
      forms_of({hole({1.5, 1.5}, {3, 3}), hole({0.5, 0.5}, {3, 3}), hole({2.5, 1}, {3, 3})});
  const std::vector<RingForms> all{outline, small, over};
  CHECK(nested(all) == std::vector<size_t>{0, 0, 2});
  // Arcs count: a head that bulges into the opening above it.
  VectorRing arch = hole({5, 1}, {6, 2});
  arch.edges[1].sagitta_m = -0.5;
  const std::vector<RingForms> stacked{outline, forms_of({hole({5, 2.2}, {6, 3})}),
                                       forms_of({arch, hole({5, 1}, {6, 2})})};
  CHECK(nested(stacked) == std::vector<size_t>{0, 0, 1});
}
