// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "cloud/operations.h"

using namespace jalon;

TEST_CASE("reduction__counts_what_went_and_its_share") {
  const Reduction some = reduction_of(200, 150);
  CHECK(some.count_in == 200);
  CHECK(some.count_out == 150);
  CHECK(some.removed == 50);
  CHECK(some.removed_percent == 25);
  CHECK(reduction_of(8, 8).removed_percent == 0);
  CHECK(reduction_of(8, 0).removed_percent == 100);
}

TEST_CASE("reduction__of_nothing_is_no_share_of_nothing") {
  const Reduction none = reduction_of(0, 0);
  CHECK(none.removed == 0);
  CHECK(none.removed_percent == 0);
}
