// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace jalon {

/// Sorts some dozens to thousands of values, a finite way apart, as a cylinder holds: to the order of std::sort, but
/// without its branches, which no processor guesses. work is memory kept between calls.
/// Few: each goes where so many come before it. Others: two rounds by the bytes of the place between least and largest
/// in 2^16 steps, which leave little to set right; where all crowd in few steps, std::sort.
void sort_along(std::vector<double>& values, std::vector<double>& work);

}  // namespace jalon
