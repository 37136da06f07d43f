// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#ifdef JALON_WITH_FCL

#include "solid/fcl_precision.h"

#include <doctest/doctest.h>

#include <cstring>

using namespace jalon;

namespace {

// A libccd of floats behind the headers of doubles: it reads and writes the first halves.
ccd_real_t of_floats(const ccd_vec3_t* point, const ccd_vec3_t*, const ccd_vec3_t*,
                     const ccd_vec3_t*, ccd_vec3_t* witness) {
  float p[3];
  std::memcpy(p, point, sizeof p);
  const float squared = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
  std::memcpy(witness, p, sizeof p);
  ccd_real_t out = 0;
  std::memcpy(&out, &squared, sizeof squared);
  return out;
}

// One that rounds to single precision but keeps the layout.
ccd_real_t rounding(const ccd_vec3_t* point, const ccd_vec3_t*, const ccd_vec3_t*,
                    const ccd_vec3_t*, ccd_vec3_t* witness) {
  const float z = static_cast<float>(point->v[2]);
  *witness = {{0, 0, 0}};
  return z * z;
}

}  // namespace

TEST_CASE("libccd__in_single_precision_is_caught_at_run_time") {
  CHECK(calculates_in_doubles(&ccdVec3PointTriDist2));
  CHECK_FALSE(calculates_in_doubles(&of_floats));
  CHECK_FALSE(calculates_in_doubles(&rounding));
}

#endif
