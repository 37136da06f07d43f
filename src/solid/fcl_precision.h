// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ccd/vec3.h>

namespace jalon {

/// libccd's squared distance of a point from a triangle, or what a test puts in its place.
using CcdPointTriangle = ccd_real_t (*)(const ccd_vec3_t* point, const ccd_vec3_t* a,
                                        const ccd_vec3_t* b, const ccd_vec3_t* c,
                                        ccd_vec3_t* witness);

/// Whether it calculates in double precision. libccd is built for one of the two, its headers say which (the build
/// checks them), but a program may be started with another library of the same name: then doubles are read as floats. A
/// distance that only doubles can tell decides.
bool calculates_in_doubles(CcdPointTriangle point_triangle);

}  // namespace jalon
