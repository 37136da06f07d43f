// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "compare/landslide/settings.h"

using namespace jalon;

TEST_CASE("landslide_settings__lists_have_whole_corners") {
  LandslideSettings settings;
  CHECK_NOTHROW(settings.check());
  CHECK(settings.corners().empty());
  settings.outline = {0, 0, 1, 5, 0, 1, 5, 5, 2};
  CHECK_NOTHROW(settings.check());
  REQUIRE(settings.corners().size() == 3);
  CHECK(settings.corners()[2].z == 2);
  settings.outline.pop_back();
  CHECK_THROWS_AS(settings.check(), Error);
  settings.outline = {0, 0, 1, 5, 0, 1};
  CHECK_THROWS_AS(settings.check(), Error);
}
